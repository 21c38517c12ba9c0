"""E2.7: A few digits too few."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Draws, Number, Task, Text, WrongAnswer, WrongStep


def few_digits(rng: Draws) -> dict:
    """Draw how pi/2 was written in a URDF, and how far away one looks, until rounding is told from other mistakes."""
    while True:
        written, range_m = float(rng.choice((1.54, 1.55, 1.61, 1.62))), round(float(rng.uniform(8.0, 30.0)), 1)
        quarters = (math.pi / 2, 11 / 7, 1.571, 3.141 / 2)
        off_m = [reach_m * abs(quarter - written) for reach_m in (range_m, 10.0) for quarter in quarters]
        if all(abs(one - round(off_m[0], 2)) > 6e-4 for one in off_m) and abs(range_m - 10.0) > 0.4:
            return {"written_yaw_rad": written, "range_m": range_m}


def aside_mm(given, *, quarter="pi / 2", unit="radians", part="whole", reach="range", length="aside", sign="dropped"):
    """Return how far off, step by step; other steps are the slips."""
    quarters = {
        "pi / 2": math.pi / 2,
        "3.14 / 2": 3.14 / 2,
        "22/7": 11 / 7,
        "three digits": 1.571,
        "3.141 / 2": 3.141 / 2,
        "pi": math.pi,
        "an eighth": math.pi / 4,
        "90": 90.0,
        "floor": 1.0,
        "none": 0.0,
    }
    missing = quarters[quarter] - given.written_yaw_rad
    missing = {"degrees": math.degrees(missing), "converted": math.radians(missing)}.get(unit, missing)
    missing *= {
        "whole": 1.0,
        "half": 0.5,
        "of a quarter turn": 2 / math.pi,
        "of a whole turn": 0.5 / math.pi,
        "twice": 2.0,
        "times pi": math.pi,
        "times 2 pi": 2 * math.pi,
    }[part]
    reach_m = {"range": given.range_m, "left out": 1.0, "squared": given.range_m**2, "10 m": 10.0,
               "root": math.sqrt(given.range_m)}[reach]  # fmt: skip
    off_m = {
        "aside": reach_m * missing,
        "range": reach_m,
        "quarter": reach_m * math.pi / 2,
        "angle in degrees": math.degrees(missing) / 1000.0,
        "shorter": reach_m * (1 - math.cos(missing)),
        "sine of degrees": reach_m * math.sin(math.degrees(missing)),
        "sine of the written": reach_m * math.sin(given.written_yaw_rad),
        "tangent of the written": reach_m * math.tan(given.written_yaw_rad),
        "cosine, converted": reach_m * math.cos(math.radians(given.written_yaw_rad)),
        "sine, converted": reach_m * math.sin(math.radians(given.written_yaw_rad)),
        "cosine, in degrees": reach_m * math.cos(math.degrees(given.written_yaw_rad)),
        "sine, in degrees": reach_m * math.sin(math.degrees(given.written_yaw_rad)),
        "both angles": reach_m * (math.pi / 2 + given.written_yaw_rad),
        "arc tangent": math.atan(reach_m * missing),
        "of the written": reach_m * missing / given.written_yaw_rad,
        "to metres": round(abs(reach_m * missing)),
        "range and angle": reach_m + abs(missing),
        "bracket missing": reach_m * quarters[quarter] - given.written_yaw_rad / 1000.0,
        "bracket missing, in metres": reach_m * quarters[quarter] - given.written_yaw_rad,
        "to centimetres": round(reach_m * missing, 2),
    }
    return 1000.0 * (abs(off_m[length]) if sign == "dropped" else -abs(off_m[length]))


DEGREES = WrongStep(
    "degrees",
    {"unit": "degrees"},
    Text(
        en="You multiplied by degrees. An arc is radius times angle only if the angle is in radians.",
        ko="도(degree)를 곱했습니다. 호의 길이가 반지름 곱하기 각도인 것은 각도가 라디안일 때뿐입니다.",
    ),
)


RELATIVE = WrongStep(
    "relative",
    {"part": "of a quarter turn"},
    Text(
        en="That is the error as a part of pi/2, times the range. The missing angle itself is what swings the ray.",
        ko="오차를 π/2로 나눈 비율에 거리를 곱했습니다. 광선을 옆으로 미는 것은 비율이 아니라 모자란 각도 자체입니다.",
    ),
)


HALF = WrongStep(
    "half",
    {"part": "half"},
    Text(
        en="This is half of it, as by half the angle. Halves belong into quaternions; the ray swings by the whole missing angle.",
        ko="절반입니다. 각도를 절반으로 나누면 이렇게 됩니다. 절반은 쿼터니언에 쓰는 것이고, 광선은 모자란 각도만큼 그대로 돌아갑니다.",
    ),
)


NEGATIVE = WrongStep(
    "negative",
    {"sign": "kept"},
    Text(
        en="How far off is asked without a sign: take abs().",
        ko="얼마나 어긋나는지는 부호 없이 답합니다. abs()를 쓰십시오.",
    ),
)


ROUNDED_PI = WrongStep(
    "rounded pi",
    {"quarter": "3.14 / 2"},
    Text(
        en="Digits were lost once more: 3.14 / 2 for a quarter turn, or an angle that was rounded, gives this. Use math.pi, and round nothing.",
        ko="자릿수가 또 없어졌습니다. 4분의 1바퀴를 3.14 / 2로 쓰거나 각도를 반올림하면 이 값이 나옵니다. math.pi를 쓰고, 반올림하지 마십시오.",
    ),
)

WHOLE_PI = WrongStep(
    "whole pi",
    {"quarter": "pi"},
    Text(
        en="You compared with π. The mount turns by a quarter of a circle, π/2.",
        ko="π와 비교했습니다. 장착은 4분의 1바퀴, 곧 π/2만큼 돕니다.",
    ),
)

TWENTY_TWO = WrongStep(
    "22/7",
    {"quarter": "22/7"},
    Text(
        en="22/7 is π to two decimals only. Use math.pi.",
        ko="22/7은 소수 둘째 자리까지만 π와 같습니다. math.pi를 쓰십시오.",
    ),
)

ALL_OF_IT = WrongStep(
    "all of the angle",
    {"quarter": "none"},
    Text(
        en="You took the whole angle that was written. What swings the ray aside is what is missing up to π/2.",
        ko="적힌 각도 전체를 썼습니다. 광선을 옆으로 미는 것은 π/2에 모자란 만큼입니다.",
    ),
)

TWICE = WrongStep(
    "twice",
    {"part": "twice"},
    Text(
        en="This is twice as far: the missing angle counts once.",
        ko="두 배입니다. 모자란 각도는 한 번만 곱합니다.",
    ),
)

NO_RANGE = WrongStep(
    "no range",
    {"reach": "left out"},
    Text(
        en="The range is missing: that is how far off a point would be at one metre.",
        ko="거리가 빠졌습니다. 1미터 앞의 점이 어긋나는 길이입니다.",
    ),
)

RANGE_SQUARED = WrongStep(
    "range squared",
    {"reach": "squared"},
    Text(
        en="The range went in twice. An arc is radius times angle, once.",
        ko="거리를 두 번 곱했습니다. 호의 길이는 반지름 곱하기 각도, 한 번입니다.",
    ),
)

THE_RANGE = WrongStep(
    "the range",
    {"length": "range"},
    Text(
        en="That is the range itself. How far does the missing angle swing a point at this range?",
        ko="거리 그 자체입니다. 모자란 각도 때문에 이 거리의 점이 얼마나 옆으로 갑니까?",
    ),
)

SHORTER = WrongStep(
    "shorter",
    {"length": "shorter"},
    Text(
        en="That is how much less far ahead the point is, 1 minus the cosine. Asked for is how far aside.",
        ko="점이 앞쪽으로 얼마나 줄었는지, 곧 1에서 cos을 뺀 것입니다. 옆으로 얼마인지가 필요합니다.",
    ),
)


CONVERTED_ONCE_MORE = WrongStep(
    "converted once more",
    {"unit": "converted"},
    Text(
        en="The missing angle went in as if it were degrees, by math.radians, by π/180 or as a part of 360. It is in radians already.",
        ko="모자란 각도를 도(degree)로 여기고 math.radians나 π/180, 360으로 나눈 비율을 쓴 값입니다. 이미 라디안입니다.",
    ),
    "M5",
)


SINE_OF_DEGREES = WrongStep(
    "sine of degrees",
    {"length": "sine of degrees"},
    Text(
        en="You gave the sine an angle in degrees. math.sin wants radians, as the URDF has them.",
        ko="sin에 도 단위 각도를 넣었습니다. math.sin은 URDF처럼 라디안을 받습니다.",
    ),
    "M5",
)


SINE_OF_THE_WRITTEN = WrongStep(
    "sine of the written",
    {"length": "sine of the written"},
    Text(
        en="That is the sine of the whole angle that was written, or the cosine of the one that is missing. What swings the ray aside is what is missing up to π/2.",
        ko="적혀 있는 각도 전체의 sin, 또는 모자란 각도의 cos입니다. 빛을 옆으로 비키게 하는 것은 π/2까지 모자란 만큼입니다.",
    ),
)


TANGENT_OF_THE_WRITTEN = WrongStep(
    "tangent of the written",
    {"length": "tangent of the written"},
    Text(
        en="You took the tangent of the whole angle that was written. What swings the ray aside is what is missing up to π/2.",
        ko="적혀 있는 각도 전체의 tan을 썼습니다. 빛을 옆으로 비키게 하는 것은 π/2까지 모자란 만큼입니다.",
    ),
)


ANGLE_IN_DEGREES = WrongStep(
    "angle in degrees",
    {"length": "angle in degrees"},
    Text(
        en="That is the missing angle, in degrees. How far does it swing a point at this range?",
        ko="모자란 각도를 도 단위로 쓴 것입니다. 이 거리에 있는 점은 그 각도만큼 돌면 얼마나 움직입니까?",
    ),
)


THREE_DIGITS = WrongStep(
    "pi / 2 to three digits",
    {"quarter": "three digits"},
    Text(
        en="This comes of 1.571, π/2 to three decimals, of 3.142 / 2, or of a difference that was rounded: far away that shows. Use math.pi, and round nothing on the way.",
        ko="1.571, 곧 소수 셋째 자리까지의 π/2나 3.142 / 2를 쓰거나 차이를 반올림하면 나오는 값입니다. 먼 곳에서는 차이가 납니다. math.pi를 쓰고 중간에 반올림하지 마십시오.",
    ),
)


PI_CUT_SHORT = WrongStep(
    "pi cut short",
    {"quarter": "3.141 / 2"},
    Text(
        en="You compared with 3.141 / 2, a π that was cut short: far away that shows. Use math.pi.",
        ko="3.141 / 2, 곧 뒤를 자른 π와 비교했습니다. 먼 곳에서는 차이가 납니다. math.pi를 쓰십시오.",
    ),
)


OF_A_WHOLE_TURN = WrongStep(
    "of a whole turn",
    {"part": "of a whole turn"},
    Text(
        en="That is the missing angle as a part of a whole circle, times the range. An arc is radius times angle: 2π is in the radians already.",
        ko="모자란 각도가 한 바퀴에서 차지하는 비율에 거리를 곱한 값입니다. 호의 길이는 반지름 곱하기 각도입니다. 라디안에는 2π가 이미 들어 있습니다.",
    ),
)


A_QUARTER_OF_A_CIRCLE = WrongStep(
    "a quarter of a circle",
    {"length": "quarter"},
    Text(
        en="That is the arc of the whole quarter turn. What swings the ray aside is only what is missing up to π/2.",
        ko="4분의 1바퀴 전체의 호입니다. 광선을 옆으로 미는 것은 π/2에 모자란 만큼뿐입니다.",
    ),
)


def off_by(name: str, steps: dict[str, str], en: str, ko: str, misconception: str = "") -> WrongAnswer:
    """Return an answer that stands alone: it composes with no other slip."""
    return WrongAnswer(name, lambda given: aside_mm(given, **steps), Text(en=en, ko=ko), misconception)


ALONE = (
    off_by(
        "at 10 m",
        {"reach": "10 m"},
        "That is how far off a point would be at 10 metres. Your range is another.",
        "10미터 앞의 점이 어긋나는 길이입니다. 문제에 주어진 거리는 다릅니다.",
    ),
    off_by(
        "root of the range",
        {"reach": "root"},
        "The root of the range went in. An arc is radius times angle: the range itself.",
        "거리의 제곱근을 곱했습니다. 호의 길이는 반지름 곱하기 각도이므로 거리를 그대로 곱합니다.",
    ),
    off_by(
        "an eighth of a circle",
        {"quarter": "an eighth"},
        "You compared with π/4. The mount turns by a quarter of a circle, π/2.",
        "π/4와 비교했습니다. 장착은 4분의 1바퀴, 곧 π/2만큼 돕니다.",
    ),
    off_by(
        "90 and radians",
        {"quarter": "90"},
        "You took radians off 90 degrees. Both angles need one unit: a quarter turn is math.pi / 2.",
        "90도에서 라디안을 뺐습니다. 두 각도의 단위를 맞추십시오. 4분의 1바퀴는 math.pi / 2입니다.",
        "M5",
    ),
    off_by(
        "times pi",
        {"part": "times pi"},
        "There is a π too many: an arc is radius times angle, and π is in the radians already.",
        "π를 한 번 더 곱했습니다. 호의 길이는 반지름 곱하기 각도이고, 라디안에는 π가 이미 들어 있습니다.",
    ),
    off_by(
        "times two pi",
        {"part": "times 2 pi"},
        "There is 2π too many, as in the way round a circle: an arc is radius times angle.",
        "원둘레를 구하듯 2π를 더 곱했습니다. 호의 길이는 반지름 곱하기 각도입니다.",
    ),
    off_by(
        "both angles together",
        {"length": "both angles"},
        "You added π/2 and the angle that was written. What swings the ray aside is their difference.",
        "π/2와 적힌 각도를 더했습니다. 광선을 옆으로 미는 것은 둘의 차이입니다.",
    ),
    off_by(
        "arc tangent",
        {"length": "arc tangent"},
        "That is an angle, an arc tangent. Asked for is a length: how far aside the point is.",
        "atan으로 구한 각도입니다. 필요한 것은 길이, 곧 점이 옆으로 벗어난 거리입니다.",
    ),
    *(
        off_by(
            name,
            {"length": name},
            f"The written angle was taken off {taken}, not off π/2: `*` and `/` come before `-`. The difference of the two "
            "angles belongs into brackets.",
            f"π/2가 아니라 {taken_ko}에서 적힌 각도를 뺐습니다. `*`와 `/`를 `-`보다 먼저 계산합니다. 두 각도의 차이를 괄호로 "
            "묶으십시오.",
        )
        for name, taken, taken_ko in (
            ("bracket missing", "the millimetres", "밀리미터로 곱한 값"),
            ("bracket missing, in metres", "the metres", "미터로 곱한 값"),
        )
    ),
    off_by(
        "pi // 2",
        {"quarter": "floor"},
        "You compared with 1, as `math.pi // 2` gives it: `//` cuts off what is behind the point. A quarter turn is math.pi / 2.",
        "1과 비교했습니다. `math.pi // 2`의 값입니다. `//`는 소수점 아래를 잘라 버립니다. 4분의 1바퀴는 math.pi / 2입니다.",
    ),
    off_by(
        "relative to the written",
        {"length": "of the written"},
        "You divided the missing angle by the one that was written. The missing angle itself is what swings the ray.",
        "모자란 각도를 적힌 각도로 나누었습니다. 광선을 옆으로 미는 것은 비율이 아니라 모자란 각도 자체입니다.",
    ),
    off_by(
        "range and angle",
        {"length": "range and angle"},
        "You added the range and the angle, metres and radians. An arc is radius times angle.",
        "거리와 각도를, 곧 미터와 라디안을 더했습니다. 호의 길이는 반지름 곱하기 각도입니다.",
    ),
    off_by(
        "to metres",
        {"length": "to metres"},
        "This is a whole number of metres, as after rounding too early: 0, or a full thousand. Round at the very end, if at all.",
        "너무 일찍 반올림해서 미터 단위의 정수, 곧 0이나 1000이 되었습니다. 반올림은 맨 마지막에만 하십시오.",
    ),
    off_by(
        "to centimetres",
        {"length": "to centimetres"},
        "This is rounded to centimetres: the last digit of the millimetres is lost. Round at the very end, if at all.",
        "센티미터까지로 반올림해서 밀리미터 자리가 없어졌습니다. 반올림은 맨 마지막에만 하십시오.",
    ),
    *(
        off_by(
            f"{what} of the written, {unit}",
            {"length": f"{what}, {unit}"},
            f"That is the {what} of the angle that was written, after it had been taken {taken}. math.sin and math.cos "
            "want radians, as the URDF has them.",
            f"적힌 각도를 {taken_ko} 뒤 {short}을 구한 값입니다. math.sin과 math.cos은 URDF처럼 라디안을 받습니다.",
            "M5",
        )
        for what, short in (("sine", "sin"), ("cosine", "cos"))
        for unit, taken, taken_ko in (
            ("converted", "for degrees", "도(degree)로 여겨 라디안으로 바꾼"),
            ("in degrees", "into degrees", "도(degree)로 바꾼"),
        )
    ),
)


TASK = Task(
    id="E2.7",
    kind="N",
    points=2,
    title=Text(en="A few digits too few", ko="모자란 숫자 몇 자리"),
    answer="off_mm",
    form=Number(unit="mm", tolerance=0.5),
    given=few_digits,
    variants=5,
    model=aside_mm,
    mistakes=(
        DEGREES,
        RELATIVE,
        HALF,
        NEGATIVE,
        ROUNDED_PI,
        WHOLE_PI,
        TWENTY_TWO,
        ALL_OF_IT,
        TWICE,
        NO_RANGE,
        RANGE_SQUARED,
        THE_RANGE,
        SHORTER,
        CONVERTED_ONCE_MORE,
        SINE_OF_DEGREES,
        SINE_OF_THE_WRITTEN,
        TANGENT_OF_THE_WRITTEN,
        ANGLE_IN_DEGREES,
        THREE_DIGITS,
        PI_CUT_SHORT,
        OF_A_WHOLE_TURN,
        A_QUARTER_OF_A_CIRCLE,
        *ALONE,
    ),
    hints=(
        Text(
            en="How large is the missing angle? And what does a small angle do to a point far away?",
            ko="모자란 각도는 얼마입니까? 작은 각도는 멀리 있는 점에 어떤 영향을 줍니까?",
        ),
        Text(
            en="The point swings along an arc: radius times angle, the angle in radians.",
            ko="점은 호를 따라 움직입니다. 반지름 곱하기 각도이고, 각도는 라디안입니다.",
        ),
        Text(
            en="abs(math.pi / 2 - written) is the angle. Metres become millimetres at the very end.",
            ko="각도는 abs(math.pi / 2 - written)입니다. 미터를 밀리미터로 바꾸는 일은 맨 마지막에 합니다.",
        ),
    ),
    misconceptions=("M5",),
)
