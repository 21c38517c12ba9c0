"""std_srvs, in process: see tflab.ros.messages.std_srvs."""
