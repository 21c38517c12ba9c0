"""Name the fifteen misconceptions that the course looks for.

A mistake belongs to one task.  A misconception is behind mistakes of several tasks.
"""

from __future__ import annotations

from ...text import Text

__all__ = ["MISCONCEPTIONS"]

MISCONCEPTIONS = {
    "M1": Text("target and source swapped", "목표와 원본을 바꿈"),
    "M2": Text("parent and child taken for the way of the data", "부모·자식을 데이터의 방향으로 여김"),
    "M3": Text("the inverse is only a minus sign", "역변환을 부호만 바꾸는 것으로 여김"),
    "M4": Text("optical frame forgotten, or applied twice", "광학 좌표계를 빠뜨리거나 두 번 적용"),
    "M5": Text("quaternion: order, degrees, zero, length", "쿼터니언의 순서·도(degree) 단위·모두 0·길이"),
    "M6": Text("two publishers for one child", "자식 하나에 발행자 둘"),
    "M7": Text("localisation publishes map to base_link", "위치 추정이 map→base_link를 발행한다고 여김"),
    "M8": Text("map pose for control; drift taken for a fault", "제어에 map 기준 포즈를 씀, 드리프트를 고장으로 여김"),
    "M9": Text("latest or receive time instead of the stamp", "측정 시각 대신 최신값이나 수신 시각을 씀"),
    "M10": Text("a timeout cures everything", "timeout이면 다 해결된다고 여김"),
    "M11": Text("the errors are all one error", "여러 오류를 하나로 여김"),
    "M12": Text("static and dynamic topics mixed up", "정적·동적 토픽을 혼동"),
    "M13": Text("bag without its tf, or clocks mixed", "bag에 tf가 없거나 시계가 섞임"),
    "M14": Text("frame names: prefix, slash, case", "좌표계 이름의 접두사·슬래시·대소문자"),
    "M15": Text("the picture is wrong, so the sensor is", "화면이 이상하면 센서 탓으로 여김"),
}
