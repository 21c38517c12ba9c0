"""Services of nav_msgs, in process."""

from tflab.ros.messages.nav_msgs import (
    GetMap as GetMap,
    GetPlan as GetPlan,
    LoadMap as LoadMap,
    SetMap as SetMap,
)
