"""Diagnose the TF of a recording, a graph or a buffer.

findings          findings and reports
evidence          what the checks examine
collect_evidence  evidence of a recording or a buffer
lookups           which lookups at the stamps of messages work, and when
checks/           the checks, by their subject
diagnose          all checks, and causes separated from effects
report/           the report as text and as a page
profile           each edge in figures
ci/               expectations, filters, and the formats of other programs
api               examine(recording | graph | buffer)
command           `tflab doctor BAG`
"""

from .api import examine

__all__ = ["examine"]
