# %% [markdown] lang="en" name="title" slide="slide"
# # 04 · The tree of frames
#
# **One parent each, and nobody checks** · about 30 minutes · builds on 03
#
# After this chapter you can
#
# - find the path between any two frames by hand: up to their common ancestor, then down,
# - tell a healthy [[tf tree]] from two trees or a loop, at a glance or with one line of Python,
# - say what tf2 checks when a transform is sent (almost nothing), and what a lookup reports,
# - name the frames of one robot and of several, and say which contract about `map` they follow.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 04 · 좌표계 트리
#
# **부모는 하나씩, 그런데 아무도 확인하지 않습니다** · 약 30분 · 03장을 바탕으로 합니다
#
# 이 장을 마치면
#
# - 어느 두 좌표계 사이의 경로든 손으로 찾을 수 있습니다. 만나는 곳까지 올라갔다가 내려가면 됩니다.
# - 멀쩡한 [[tf tree|TF 트리]]와 둘로 나뉜 트리, 고리(loop)가 생긴 트리를 한눈에, 또는 파이썬 한 줄로 구별할 수 있습니다.
# - 변환을 발행할 때 tf2가 확인하는 것(거의 없습니다)과, 조회할 때 나는 오류를 말할 수 있습니다.
# - 로봇이 한 대일 때와 여러 대일 때 좌표계 이름을 정하고, `map`에 대해 어떤 약속을 따르는지 말할 수 있습니다.

# %% [markdown] lang="en" name="title-notes" slide="notes"
# Ask before the first slide: which program makes sure that the frames of a robot form a tree? Collect names. The answer of this chapter: none.

# %% [markdown] lang="ko" name="title-notes" slide="notes"
# 첫 슬라이드 전에 묻습니다. 로봇의 좌표계가 트리를 이루도록 누가 보장할까요? 프로그램 이름들이 나올 것입니다. 이 장의 답은 “아무도”입니다.

# %% name="load" slide="skip"
# %load_ext tflab
from tflab.workbook import lesson

# %% [markdown] lang="en" name="story" slide="slide"
# ## The dog that was its own ancestor
#
# A four-legged robot gets a new driver. The robot worked yesterday. Today its log fills with
#
# ```
# The tf tree is invalid because it contains a loop.
# ```
#
# Its body is a child of `odom`, as before. But now `odom` is a child of the body as well: each is the other's [[parent frame|parent]].
# The cause was one string. The driver joined the robot's name, a slash and `odom`. This robot had no name, so the driver looked for `/odom`, and `/odom` is not `odom` (rai-opensource/spot_ros2, 2024).
# A year later the same kind of slash, in `/base_footprint`, stopped the mapping program of a very popular teaching robot (ROBOTIS-GIT/turtlebot3, 2025).

# %% [markdown] lang="ko" name="story" slide="slide"
# ## 자기 자신 아래에 매달린 로봇 개
#
# 네 발 로봇의 드라이버를 새 버전으로 올렸습니다. 어제까지 잘 걷던 로봇의 로그가 오늘은 이 문장으로 가득합니다.
#
# ```
# The tf tree is invalid because it contains a loop.
# ```
#
# 몸체(body)는 늘 그랬듯 `odom` 아래에 있습니다. 그런데 이제 `odom`도 몸체 아래에 있습니다. 서로가 서로의 [[parent frame|부모]]입니다.
# 원인은 문자열 하나였습니다. 드라이버는 로봇 이름과 슬래시와 `odom`을 붙여 이름을 만들었는데, 이 로봇에는 이름이 없었습니다. 그래서 만들어진 이름은 `/odom`이었고, `/odom`은 `odom`이 아닙니다(rai-opensource/spot_ros2, 2024년).
# 1년 뒤에는 널리 쓰이는 교육용 로봇의 지도 작성 노드도 슬래시가 붙은 이름 `/base_footprint` 때문에 멈추었습니다(ROBOTIS-GIT/turtlebot3, 2025년).

# %% [markdown] lang="en" name="story-sources" slide="skip"
# *Read the reports:* spot_ros2 [302](https://github.com/rai-opensource/spot_ros2/issues/302), [304](https://github.com/rai-opensource/spot_ros2/pull/304); turtlebot3 [1064](https://github.com/ROBOTIS-GIT/turtlebot3/pull/1064), [1066](https://github.com/ROBOTIS-GIT/turtlebot3/issues/1066).

# %% [markdown] lang="ko" name="story-sources" slide="skip"
# *더 읽기:* spot_ros2 [302](https://github.com/rai-opensource/spot_ros2/issues/302), [304](https://github.com/rai-opensource/spot_ros2/pull/304), turtlebot3 [1064](https://github.com/ROBOTIS-GIT/turtlebot3/pull/1064), [1066](https://github.com/ROBOTIS-GIT/turtlebot3/issues/1066).

# %% name="the-driver" slide="subslide"
def driver(name):
    """Return the edge (parent, child) that the story's driver sends for a robot of this name."""
    wanted = name + "/" + "odom"
    prefix = name + "/" if name else ""
    odom, body = prefix + "odom", prefix + "body"
    if odom == wanted:
        return odom, body  # parent, child: the body hangs below odom
    return body, odom  # every other frame hangs below the body


print(driver("spot"))
print(driver(""))

# %% [markdown] lang="en" name="the-driver-seen"
# With a name, the result is right. Without one, the comparison fails, and nothing reports an error.

# %% [markdown] lang="ko" name="the-driver-seen"
# 이름이 있으면 괜찮습니다. 이름이 없으면 비교가 어긋나고, 아무 오류도 나지 않습니다.

# %% [markdown] lang="en" name="story-notes" slide="notes"
# Let the class find the fault in the six lines before you say it.
# Then ask which test would have caught it.
# The answer is a test with a robot that has no name. Few people write that test.

# %% [markdown] lang="ko" name="story-notes" slide="notes"
# 답을 알려 주기 전에 여섯 줄에서 잘못을 찾게 합니다.
# 누군가 찾으면, 어떤 시험을 했다면 미리 찾았을지 묻습니다.
# 이름 없는 로봇으로 하는 시험입니다.
# 개발자의 책상 위에는 대개 그런 로봇이 없습니다.

# %% [markdown] lang="en" name="a-dict" slide="slide"
# ## TF is a dict
#
# Forget rotations for a moment. TF stores one parent for each child.
# One key has one value, so a [[frame]] has one parent. A frame without a parent is a [[root]]. One entry is an [[edge]].

# %% [markdown] lang="ko" name="a-dict" slide="slide"
# ## TF는 dict입니다
#
# 회전은 잠시 잊어 봅시다. 좌표계의 트리는 자식마다 부모 하나를 적은 dict입니다.
# 키 하나에는 값이 하나이므로 [[frame|좌표계]]의 부모도 하나입니다. 누구의 자식도 아닌 좌표계가 [[root|루트(root)]]이고, 항목 하나가 [[edge|연결(edge)]]입니다.

# %% name="parent-of" slide="-"
parent_of = {
    "odom": "map",
    "base_link": "odom",
    "laser_frame": "base_link",
    "camera_link": "base_link",
    "camera_optical_frame": "camera_link",
}

# %% name="way-up" slide="-"
def way_up(frame):
    way = [frame]
    while way[-1] in parent_of:
        way.append(parent_of[way[-1]])
    return way


print(way_up("laser_frame"))
print(way_up("camera_optical_frame"))

# %% [markdown] lang="en" name="up-and-down" slide="slide"
# ## Up, then down
#
# Both printed paths end at `map`. From their first common frame on, they are the same, and those edges cancel. So a lookup needs only the edges up from the source to that frame, and down from it to the target.
#
# The folded cell fills a `Buffer` with these edges, without any node. Its function `send(buffer, parent, child, x)` stores one static edge, which is valid at all times. By default the edge is one metre long, along x.

# %% [markdown] lang="ko" name="up-and-down" slide="slide"
# ## 올라갔다가 내려갑니다
#
# 두 좌표계에서 올라가는 경로는 모두 `map`에서 끝납니다. 만난 뒤로는 같은 경로이므로 그 연결들은 서로 상쇄됩니다. 그래서 조회에는 원본에서 두 경로가 만나는 곳까지 올라가는 연결과, 거기서 목표까지 내려가는 연결만 필요합니다.
#
# 접힌 셀은 노드 없이 `Buffer`에 이 연결들을 채웁니다. 거기서 정의한 `send(buffer, parent, child, x)`는 연결 하나를 저장합니다. 모든 시각에 유효한 정적 변환이고, 따로 정하지 않으면 x 방향으로 1미터입니다.

# %% name="a-buffer" tags=["collapsed"] slide="skip"
# Define send(), and fill a buffer.
from geometry_msgs.msg import TransformStamped
from rclpy.time import Time
from tf2_ros import Buffer, TransformException

def send(buffer, parent, child, x=1.0):
    message = TransformStamped()
    message.header.frame_id, message.child_frame_id = parent, child
    message.transform.translation.x, message.transform.rotation.w = x, 1.0
    buffer.set_transform_static(message, "page")


buffer = Buffer()
for child, parent in parent_of.items():
    send(buffer, parent, child)

# %% name="the-walk" tags=["collapsed"] slide="-"
# Draw the path.
lesson.draw_walk(buffer, "camera_optical_frame", "laser_frame")

# %% [markdown] lang="en" name="the-walk-seen"
# Solid arrows go up, dashed ones down, the numbers count the steps, and the ring marks the common frame.
# The path gives the product of transforms of chapter 03. Each step up is an edge as it was sent, each step down is an inverse. The path goes from source to target. In the product you read the same steps from right to left.

# %% [markdown] lang="ko" name="the-walk-seen"
# *그림 읽기:* source = 원본, target = 목표, 실선 화살표 = 올라감, 점선 화살표 = 내려감, 숫자 = 단계의 순서, 둥근 테 = 두 경로가 만나는 곳입니다.
# 03장의 합성을 트리에서 읽은 것입니다. 올라가는 단계는 발행된 연결 그대로이고, 내려가는 단계는 그 역변환입니다. 단계는 원본에서 시작하여 목표에서 끝나고, 합성한 식은 오른쪽 끝에서 왼쪽으로 읽습니다.

# %% [markdown] lang="en" name="walk-notes" slide="notes"
# One person is the laser and one the camera. They walk to each other by naming parents only.
# They meet at the base and not at the map. Say that aloud: the edges above the base do not matter for this lookup.

# %% [markdown] lang="ko" name="walk-notes" slide="notes"
# 한 사람은 레이저, 한 사람은 카메라가 되어 부모 이름만 부르며 서로에게 갑니다.
# 지도가 아니라 base에서 만납니다.
# 이 점을 소리 내어 말합니다.
# base보다 위에 있는 연결은 이 조회의 값에 영향을 주지 않습니다.

# %% name="the-product" tags=["collapsed"] slide="fragment"
# Draw the dominoes.
lesson.draw_dominoes(
    ("camera_optical_frame", "camera_link"), ("camera_link", "base_link"), ("base_link", "laser_frame")
)

# %% [markdown] lang="en" name="faded" slide="subslide"
# ### Now you write
#
# Without running anything: which steps, up and down, lead from `camera_optical_frame` to `odom`? And from `map` to `camera_link`? Fill in the blanks. Name each step, up or down, after the child of its edge.
#
# ```
# camera_optical_frame -> odom      up ____________, up ____________, up ____________
# map -> camera_link                down __________, down __________, down __________
# ```
#
# <details><summary>Compare</summary>
#
# Up from `camera_optical_frame`, `camera_link`, `base_link`. Down to `odom`, `base_link`, `camera_link`.
#
# </details>

# %% [markdown] lang="ko" name="faded" slide="subslide"
# ### 빈칸을 채워 보세요
#
# 실행하지 말고 생각해 보세요. 원본 `camera_optical_frame`, 목표 `odom`인 조회와 원본 `map`, 목표 `camera_link`인 조회는 각각 어떤 단계를 거칠까요? 빈칸마다 그 단계에서 지나는 연결의 자식 이름을 써 보세요.
#
# ```
# camera_optical_frame -> odom      up ____________, up ____________, up ____________
# map -> camera_link                down __________, down __________, down __________
# ```
#
# <details><summary>맞춰 보기</summary>
#
# 첫째 조회는 `camera_optical_frame`, `camera_link`, `base_link`에서 차례로 올라갑니다. 둘째 조회는 `odom`, `base_link`, `camera_link`로 차례로 내려갑니다. 어느 쪽이든 단계에는 자식의 이름을 붙입니다.
#
# </details>

# %% [markdown] lang="en" name="predict" slide="slide"
# ## Predict
#
# 1. A node sends `camera_link` once more, now as a child of the gripper `tool0`. How many cameras are in the tree afterwards: one, two, or is it an error?
# 2. Another robot's tree is `map → odom` and `odm → base_link → laser_frame`. Somebody typed `odm`. Which of these lookups succeed: `laser_frame` in `odm`, `odom` in `map`, `base_link` in `map`? And does the error name the typo?

# %% [markdown] lang="ko" name="predict" slide="slide"
# ## 예측해 봅시다
#
# 1. 누군가 `camera_link`를 한 번 더 발행합니다. 이번에는 그리퍼 `tool0`의 자식으로 발행합니다. 그러면 버퍼에 있는 카메라는 몇 대일까요? 하나일까요, 둘일까요, 아니면 오류일까요?
# 2. 다른 로봇의 트리는 `map → odom`과 `odm → base_link → laser_frame`입니다. 누군가 `odm`이라고 잘못 입력했습니다. `odm` 기준의 `laser_frame`, `map` 기준의 `odom`, `map` 기준의 `base_link` 가운데 어느 조회가 성공할까요? 오류 메시지에 오타가 나올까요?

# %% [markdown] lang="en" name="predict-notes" slide="notes"
# Hands for each. For the first, the common wrong answer is "two". For the second, it is "none", and "the error names odm".

# %% [markdown] lang="ko" name="predict-notes" slide="notes"
# 하나씩 손을 들게 합니다. 1번은 “두 대”, 2번은 “모두 안 된다”와 “오류가 odm을 알려 준다”가 나올 법한 오답입니다.

# %% name="my-guess" slide="skip"
cameras, answers = ..., ...  # a number; three times "yes" or "no"

# %% name="moved" tags=["predicted"] slide="fragment"
send(buffer, "base_link", "tool0", x=0.5)
send(buffer, "tool0", "camera_link", x=0.1)
lesson.draw_walk(buffer, "base_link", "camera_optical_frame")

# %% [markdown] lang="en" name="moved-seen" tags=["predicted"]
# One camera. A key that is set again gets a new value, so the camera moved, with all its children. No node was asked or notified.
# If two nodes set it alternately, it moves back and forth. The program in *On a real robot* reports each such change.

# %% [markdown] lang="ko" name="moved-seen" tags=["predicted"]
# 카메라는 한 대입니다. dict의 같은 키에 다시 쓰면 값이 바뀝니다. 카메라의 부모가 바뀌었고, 카메라 아래의 좌표계도 함께 따라갔습니다. 오류도 알림도 없었습니다.
# 두 노드가 번갈아 발행하면 부모가 계속 바뀝니다. *실제 로봇에서* 절에 있는 프로그램은 부모가 바뀔 때마다 알려 줍니다.

# %% name="typo" tags=["predicted"] slide="fragment"
island = Buffer()
for parent, child in (("map", "odom"), ("odm", "base_link"), ("base_link", "laser_frame")):
    send(island, parent, child)
for target, source in (("odm", "laser_frame"), ("map", "odom"), ("map", "base_link")):
    try:
        x = island.lookup_transform(target, source, Time()).transform.translation.x
        print(f"{source} in {target}: {x:.1f} m along x")
    except TransformException as error:
        print(f"{source} in {target}: {type(error).__name__}: {error}")

# %% [markdown] lang="en" name="typo-seen" tags=["predicted"]
# Yes, yes, no. Each part works by itself; only a lookup between the parts fails. The error names the two frames of the *lookup*, not the two frames between which the edge is missing.
# It also contains "Tf has two or more unconnected trees", so look at the roots.

# %% [markdown] lang="ko" name="typo-seen" tags=["predicted"]
# 됩니다, 됩니다, 안 됩니다. 나뉜 트리는 저마다 잘 동작하고, 두 트리에 걸친 조회만 실패합니다. 오류 메시지에는 *조회*의 두 이름이 나올 뿐, 연결이 끊긴 곳은 나오지 않습니다.
# “Tf has two or more unconnected trees”라고 나오므로 루트를 보면 됩니다.

# %% [markdown] lang="en" name="typo-notes" slide="notes"
# Look at the counts on the board.
# Two of three lookups succeed on a broken robot: that is why nobody notices.
# Read the error aloud and ask where it shows the typo.
# It does not.

# %% [markdown] lang="ko" name="typo-notes" slide="notes"
# 칠판의 숫자를 봅니다.
# 고장 난 로봇에서 조회 셋 가운데 둘은 됩니다.
# 그래서 아무도 알아채지 못합니다.
# 오류 메시지를 소리 내어 읽고 오타가 어디에 있는지 묻습니다.
# 어디에도 없습니다.

# %% [markdown] lang="en" name="one-line" slide="slide"
# ## A diagnosis in one line
#
# Which frames are parents but not children? Two sets give the answer.

# %% [markdown] lang="ko" name="one-line" slide="slide"
# ## 한 줄로 하는 진단
#
# 누군가의 부모이면서 누구의 자식도 아닌 것은 무엇일까요? 파이썬의 set으로 알 수 있습니다.

# %% name="roots" slide="-"
def roots(tree):
    return sorted(set(tree.values()) - set(tree))


print("healthy  ", roots(parent_of))
print("typo     ", roots({"odom": "map", "base_link": "odm", "laser_frame": "base_link"}))
print("the dog  ", roots({"body": "odom", "odom": "body", "head": "body"}))

# %% [markdown] lang="en" name="roots-seen"
# One name means a tree. Two names mean that there is a gap. The unexpected name is a typo, or a frame whose own edge no node sends. No name means a loop.
# There is one exception: this line does not show a loop *beside* a healthy tree. For a frame in such a loop, `way_up` never ends.

# %% [markdown] lang="ko" name="roots-seen"
# 이름이 하나면 트리입니다. 둘이면 어딘가 끊겼습니다. 예상하지 못한 이름은 오타이거나, 그 위의 연결을 아무도 발행하지 않는 좌표계입니다. 하나도 없으면 고리입니다.
# 한 가지 조심할 것이 있습니다. 멀쩡한 트리 *옆에* 따로 생긴 고리는 이 한 줄로 찾지 못합니다. 그때는 어떤 좌표계의 `way_up`이 끝나지 않습니다.

# %% [markdown] lang="en" name="five-rules" slide="slide"
# ## Five rules, and what enforces them
#
# 1. Each child has one parent.
# 2. Between any two frames there is one path.
# 3. Each edge has one [[authority|owner]]: one node that sends it.
# 4. No loops.
# 5. Names, directions and times mean the same everywhere.
#
# tf2 enforces none of them when a transform is *sent*. It rejects only what it cannot store: an empty name, a frame that is its own parent, a value that is not a number (NaN), a quaternion of zeros, or a transform that is older than the buffer's history. It then only logs the reason, and the program goes on. Break the rules yourself: give a frame another parent, then look up a transform.

# %% [markdown] lang="ko" name="five-rules" slide="slide"
# ## 다섯 가지 규칙, 누가 지키게 할까요?
#
# 1. 자식마다 부모는 하나입니다.
# 2. 어느 두 좌표계 사이에도 경로는 하나입니다.
# 3. 연결마다 [[authority|발행자]]는 하나입니다.
# 4. 고리가 없습니다.
# 5. 모든 노드가 이름, 방향, 시각을 같은 뜻으로 씁니다.
#
# 변환을 *발행할 때* tf2는 이 가운데 아무것도 확인하지 않습니다. 저장할 수 없는 것, 곧 빈 이름, 자기 자신이 부모인 좌표계, 숫자가 아닌 값(NaN), 모두 0인 쿼터니언, 버퍼의 보관 시간보다 오래된 변환만 거절합니다. 거절할 때도 로그에 이유를 남길 뿐이고 프로그램은 계속 실행됩니다. 나머지는 직접 어겨 보세요. 좌표계의 부모를 바꾸고 나서 조회해 보세요.

# %% name="tree-panel" tags=["interactive", "collapsed"]
# Show the panel.
lesson.tree_panel(parent_of, "map", "laser_frame")

# %% name="tree-still" tags=["static"]
broken = Buffer()
for child, parent in {**parent_of, "odom": "odm"}.items():
    send(broken, parent, child)
lesson.draw_walk(broken, "camera_link", "laser_frame")

# %% [markdown] lang="en" name="panel-tasks"
# Try three changes: make `odom` a child of `laser_frame`, of `odm`, and of itself. After each change, look up target `camera_link`, source `laser_frame`. Which faults does that lookup not show?

# %% [markdown] lang="ko" name="panel-tasks"
# `odom`을 `laser_frame` 아래에, `odm` 아래에, 자기 자신 아래에 매달아 보세요. 그때마다 목표 `camera_link`, 원본 `laser_frame`으로도 조회해 보세요. 이 조회로는 찾지 못하는 고장은 무엇일까요?

# %% [markdown] lang="en" name="tree-still-seen"
# With `odom` as a child of `odm`, the path between two sensors is as short as before. That is why a broken tree can work for weeks: a lookup fails only if its path crosses the gap.

# %% [markdown] lang="ko" name="tree-still-seen"
# `odom`이 `odm` 아래에 있어도 두 센서 사이의 경로는 그대로입니다. 고장 난 트리가 몇 주씩 멀쩡해 보이는 까닭입니다. 실패하는 것은 끊긴 곳을 지나는 조회뿐입니다.

# %% [markdown] lang="en" name="rules-notes" slide="notes"
# In the panel, let the class give the orders: odom below the laser, below itself.
# Before each lookup, hands: will it succeed?
# The log line for the last one reports the only transform of this chapter that is rejected.

# %% [markdown] lang="ko" name="rules-notes" slide="notes"
# 패널은 청중이 시키는 대로 움직입니다. odom을 레이저 아래에, 자기 자신 아래에 매답니다.
# 조회할 때마다 손을 들게 합니다.
# 값이 나올까요?
# 마지막 것에서 로그 한 줄이 나옵니다. 이 장에서 거절되는 변환은 이것뿐입니다.

# %% [markdown] lang="en" name="names" slide="slide"
# ## Names are strings
#
# `odom`, `Odom` and `odom` followed by a space are three frames. And a slash in front?

# %% [markdown] lang="ko" name="names" slide="slide"
# ## 이름은 문자열입니다
#
# `odom`, `Odom`, 뒤에 공백이 붙은 `odom `은 서로 다른 세 좌표계입니다. 앞에 슬래시가 붙으면 어떨까요?

# %% name="spellings" slide="-"
names = Buffer()
for number, parent in enumerate(["/odom", "//odom", "Odom", "odom "]):
    send(names, parent, f"child_{number}")
print(sorted(name for name in names.core.frame_names() if "child" not in name))
for target, source in (("odom", "child_0"), ("/odom", "child_0"), ("//odom", "child_1")):
    try:
        names.lookup_transform(target, source, Time())
        print(f"{target} answers")
    except TransformException as error:
        print(f"{type(error).__name__}: {error}")

# %% [markdown] lang="en" name="spellings-seen"
# One leading slash is accepted when you *send*: the name is stored as `odom`. It is rejected in a *lookup*. And `//odom` is stored as `/odom`, a frame that no lookup can name.
# Some other programs, such as the mapping program of the story, accept no leading slash. Write names without it, and do not mix spellings.

# %% [markdown] lang="ko" name="spellings-seen"
# *발행할 때는* 이름 앞의 슬래시 하나를 무시하고 `odom`으로 저장합니다. *조회할 때는* 거절합니다. 그리고 `//odom`은 `/odom`으로 저장되는데, 이 좌표계의 변환은 아무도 조회할 수 없습니다.
# 맨 앞의 슬래시를 무시하지 않는 프로그램도 있습니다. 이야기 속의 지도 작성 노드는 슬래시가 있으면 멈춥니다. 이름 앞에는 슬래시를 쓰지 말고, 표기를 섞어 쓰지 마십시오.

# %% [markdown] lang="en" name="two-contracts" slide="subslide"
# ### Several robots: choose one of two contracts
#
# A [[namespace]] is put before the names of a robot's nodes and topics. It is *not* put before frames: a frame is a string in a message, and `/tf` is usually one topic for all. So every frame that belongs to one robot needs a [[frame prefix]], as in `robot1/odom`. Does `map` belong to one robot?
#
# | | one `map` for all | a map for each robot |
# |---|---|---|
# | frames | `map`, `robot1/odom`, `robot1/base_link`, … | `robot1/map`, `robot1/odom`, `robot1/base_link`, … |
# | suits | a fleet that shares one prepared map | robots that build their own maps, or work apart |
# | costs | every localisation must use the same map and the same origin | one more edge for each robot, and somebody must find its value |
# | who joins the robots | nobody else: each localisation sends `map → robotN/odom` | one node sends `world → robot1/map` and `world → robot2/map` |
# | without that node | | two trees: a lookup between two robots fails |
#
# The lecture (§26) names both. Choose one for the whole system: navigation, sensor messages, URDF and RViz's Fixed Frame must follow the same contract. This page and its tasks assume one shared `map`.

# %% [markdown] lang="ko" name="two-contracts" slide="subslide"
# ### 로봇이 여러 대일 때: 두 가지 약속 가운데 하나
#
# [[namespace|네임스페이스(namespace)]]는 로봇의 노드와 토픽 이름 앞에 붙습니다. 좌표계 이름에는 붙지 *않습니다*. 좌표계 이름은 메시지 속의 문자열이고, `/tf`는 대개 모든 로봇이 함께 쓰는 토픽 하나입니다. 그래서 한 로봇에 속한 좌표계에는 모두 `robot1/odom`처럼 [[frame prefix|접두사(frame prefix)]]를 붙입니다. 그렇다면 `map`은 한 로봇에 속할까요?
#
# | | 모두가 쓰는 `map` 하나 | 로봇마다 지도 하나 |
# |---|---|---|
# | 좌표계 | `map`, `robot1/odom`, `robot1/base_link`, … | `robot1/map`, `robot1/odom`, `robot1/base_link`, … |
# | 알맞은 경우 | 미리 만든 지도 하나를 여러 로봇이 함께 쓸 때 | 로봇마다 지도를 만들거나 따로 일할 때 |
# | 부담 | 모든 위치 추정 노드가 같은 지도와 같은 원점을 써야 합니다 | 로봇마다 연결이 하나 더 있고, 그 값을 누군가 구해야 합니다 |
# | 로봇들을 연결하는 노드 | 따로 없습니다. 위치 추정 노드가 저마다 `map → robotN/odom`을 발행합니다 | 한 노드가 `world → robot1/map`과 `world → robot2/map`을 발행합니다 |
# | 그 노드가 없으면 | | 트리가 둘이 되어 두 로봇 사이의 조회가 실패합니다 |
#
# 강의(§26)에는 둘 다 나옵니다. 시스템 전체에 하나를 정하십시오. 내비게이션, 센서 메시지, URDF, RViz의 고정 좌표계(Fixed Frame)가 모두 같은 약속을 따라야 합니다. 이 페이지와 과제에서는 `map` 하나를 함께 쓴다고 가정합니다.

# %% [markdown] lang="en" name="break-it" slide="slide"
# ## Break it: the dog's loop
#
# The body is a child of odom, odom is a child of the body, and the body has the children head and back. **Predict** for each: does the lookup succeed?
#
# - the body in `odom` · the head in `odom` · `odom` in the head · the back in the head

# %% [markdown] lang="ko" name="break-it" slide="slide"
# ## 일부러 고장 내기: 로봇 개의 고리
#
# 몸체는 odom 아래, odom은 몸체 아래, 그리고 몸체에는 머리(head)와 등(back)이 있습니다. 다음 네 조회에서 각각 값이 나올까요? **예측해 봅시다.**
#
# - `odom` 기준의 몸체 · `odom` 기준의 머리 · 머리 기준의 `odom` · 머리 기준의 등

# %% name="the-loop" tags=["predicted"]
dog = Buffer()
for parent, child, x in (("odom", "body", 2.0), ("body", "odom", -2.0), ("body", "head", 0.4), ("body", "back", -0.4)):
    send(dog, parent, child, x)
for target, source in (("odom", "body"), ("odom", "head"), ("head", "odom"), ("head", "back")):
    try:
        x = dog.lookup_transform(target, source, Time()).transform.translation.x
        print(f"{source} in {target}: {x:.1f} m")
    except TransformException as error:
        print(f"{source} in {target}: {type(error).__name__}: {str(error).splitlines()[0]}")

# %% name="the-loop-drawn" tags=["predicted", "collapsed"] slide="-"
# Draw the loop.
lesson.draw_walk(dog, "head", "back")

# %% [markdown] lang="en" name="the-loop-seen" tags=["predicted"]
# Yes, yes, no, no. The head in `odom` can be found, but not the transform between two parts of one body. tf2 climbs from the source towards the root. If it reaches the target, it stops and answers. It does not stop at the common frame. Here there is no root, so it goes round the loop, and after a thousand steps it raises the exception of the story.
# So a tree with a loop also works for some lookups. A pull request that removed such a loop notes that most ROS code ignores loops, "but some nodes get very upset" (mavlink/mavros [1252](https://github.com/mavlink/mavros/pull/1252)).

# %% [markdown] lang="ko" name="the-loop-seen" tags=["predicted"]
# *그림 읽기:* again = 이미 나온 좌표계로 되돌아온 곳입니다.
# 됩니다, 됩니다, 안 됩니다, 안 됩니다. 한 몸에 고정된 두 부품 사이의 변환은 구하지 못하는데, `odom` 기준 머리의 위치는 구합니다. tf2는 원본에서 올라갑니다. 도중에 목표를 만나면 멈추고 값을 반환합니다. 만나지 못하면 고리를 돌다가 1,000단계쯤에서 그만두고, 이야기에 나온 그 오류를 냅니다.
# 그래서 고리가 있어도 성공하는 조회가 있습니다. 고리를 없앤 어느 풀 리퀘스트(pull request)에는, 대부분의 코드에는 문제가 없지만 몇몇 노드는 크게 잘못된다고 적혀 있습니다(mavlink/mavros [1252](https://github.com/mavlink/mavros/pull/1252)).

# %% [markdown] lang="en" name="loop-notes" slide="notes"
# There is no transform between two parts of one body.
# Pause, then ask why the head in odom works: tf2 stops at the first frame that is the target.
# After a thousand steps it gives up.

# %% [markdown] lang="ko" name="loop-notes" slide="notes"
# 한 몸의 두 부품 사이의 변환을 구하지 못합니다.
# 잠시 생각할 시간을 줍니다.
# 그다음 odom 기준의 머리는 왜 되는지 묻습니다. tf2는 도중에 목표를 만나면 멈추기 때문입니다.
# 만나지 못하면 1,000단계에서 그만둡니다.

# %% [markdown] lang="en" name="two-owners" slide="slide"
# ## Two publishers of one edge
#
# The node `wheel_odometry` calculates the robot's pose from the wheels and publishes it as `odom → base_footprint`. Now a filter is started that also uses an IMU (an EKF, extended Kalman filter), and publishes the same edge. The errors of both grow independently.
#
# The folded cells start the nodes and a listener. `place` looks up the position of `source` in `target`. Time in the simulation advances only during `graph.run(seconds=…)`.
# **Predict:** what does a test of five seconds show?

# %% [markdown] lang="ko" name="two-owners" slide="slide"
# ## 한 연결을 두 노드가 발행할 때
#
# `wheel_odometry` 노드는 바퀴의 회전에서 로봇의 포즈 `odom → base_footprint`를 발행합니다. 여기에 IMU까지 써서 포즈를 추정하는 필터(EKF, 확장 칼만 필터)를 켜자 이 노드도 같은 연결을 발행합니다. 두 노드의 오차는 조금씩, 서로 다르게 쌓입니다.
#
# 접힌 셀에서 노드들과 수신기를 시작합니다. `place`는 `target`을 기준으로 `source`가 어디에 있는지 조회합니다. 이 페이지의 시간은 `graph.run(seconds=…)`를 호출할 때만 흐릅니다.
# **예측해 봅시다.** 작업대 위에서 5초 동안 시험하면 무엇이 보일까요?

# %% name="two-nodes" tags=["collapsed"] slide="skip"
# Start the nodes and a listener.
import math

import rclpy
from rclpy.node import Node
from tf2_ros import TransformListener

parts = ["robot_state_publisher", "joint_driver", "wheel_odometry", "localization"]
graph = lesson.new_graph()
lesson.launch(graph, lesson.TeachingRobot(), only=[*parts, "ekf_filter_node"])
rclpy.init()
node = Node("asker")
tf_buffer = Buffer()
listener = TransformListener(tf_buffer, node, spin_thread=True)
graph.run(seconds=1.0)

# %% name="place" tags=["collapsed"] slide="skip"
# Define place().
def place(target, source):
    at = tf_buffer.lookup_transform(target, source, Time()).transform.translation
    return at.x, at.y

# %% name="steps-of-both" tags=["predicted"] slide="-"
before, largest, past = place("odom", "base_footprint"), 0.0, 0.0
for until in (5, 10, 20, 30):
    for _ in range(round((until - past) / 0.02)):
        graph.run(seconds=0.02)
        here = place("odom", "base_footprint")
        before, largest = here, max(largest, math.dist(before, here))
    past = until
    print(f"after {until:>2} s: largest step in 20 ms {largest:.2f} m")

# %% [markdown] lang="en" name="steps-of-both-seen" tags=["predicted"]
# At half a metre per second, and with 20 or 30 messages a second, one publisher alone would move the robot by about two centimetres per message. After five seconds the largest step is four centimetres, which nobody sees. After half a minute the robot jumps by half a metre. The short test passes; the drive through the hall does not.

# %% [markdown] lang="ko" name="steps-of-both-seen" tags=["predicted"]
# 0.5 m/s로 달리고 메시지가 1초에 20~30번 오므로, 한 노드만 발행하면 한 번에 2센티미터쯤 움직입니다. 5초까지 가장 큰 변화는 4센티미터라 아무도 알아채지 못합니다. 30초가 지나면 로봇은 0.5미터씩 튑니다. 작업대에서 한 시험은 통과하지만, 복도를 달리면 드러납니다.

# %% name="owners" tags=["collapsed"] slide="subslide"
# Show each edge with its rate and its publishers.
lesson.frame_tree(graph, seconds=2.0)

# %% [markdown] lang="en" name="owners-seen"
# The *shape* of this tree is correct: one parent each. The rate reveals the fault: 50 Hz = 20 + 30. Here the two names in the last column reveal it, too, because all nodes are in one process. The fix is to choose one publisher. Here only the filter keeps publishing the edge.

# %% [markdown] lang="ko" name="owners-seen"
# *그림 읽기:* rate = 발행률, age = 나이, published by = 발행자, D(dynamic) = 동적, S(static) = 정적. 아래 줄은 한 연결을 두 노드가 발행한다는 경고입니다.
# 트리의 *모양*은 정상입니다. 부모가 하나씩입니다. 문제는 발행률에 드러납니다. 50 Hz는 바퀴 오도메트리의 20 Hz와 필터의 30 Hz를 더한 값입니다. 여기서는 모든 노드가 한 프로세스 안에 있어서 이름도 둘 보입니다. 고치려면 하나를 고릅니다. 여기서는 바퀴 오도메트리 노드의 발행을 끕니다.

# %% [markdown] lang="en" name="owners-notes" slide="notes"
# Cover the last column with your hand: from the shape alone nobody could tell.
# Then the rate: who knows from memory how often their own odometry publishes?
# Without that number, 50 Hz tells you nothing.

# %% [markdown] lang="ko" name="owners-notes" slide="notes"
# 맨 오른쪽 열을 손으로 가립니다.
# 모양만으로는 알 수 없습니다.
# 그다음은 발행률을 봅니다.
# 자기 로봇의 오도메트리가 1초에 몇 번 발행하는지 외우고 있는 사람이 있습니까?
# 그 수를 모르면 50 Hz도 아무것도 알려 주지 않습니다.

# %% name="cure" slide="-"
# %ros2 param set /wheel_odometry publish_tf false

# %% name="cured" slide="-"
graph.run(seconds=1.0)
before, largest = place("odom", "base_footprint"), 0.0
for _ in range(250):
    graph.run(seconds=0.02)
    here = place("odom", "base_footprint")
    before, largest = here, max(largest, math.dist(before, here))
print(f"five more seconds: largest step in 20 ms {largest:.2f} m")

# %% [markdown] lang="en" name="cured-seen"
# The largest step is two centimetres. That is the distance driven between two messages of the filter, which sends thirty a second. Check the tree again after such a fix, and do not trust the parameter alone. In ros-controls/ros_controllers [499](https://github.com/ros-controls/ros_controllers/issues/499) it was set, and the tree still alternated.

# %% [markdown] lang="ko" name="cured-seen"
# 2센티미터입니다. 필터가 1초에 서른 번 발행하므로, 한 번 발행하고 다음에 발행할 때까지 실제로 달린 거리입니다. 고친 뒤에는 다시 확인하고, 설정값만 믿지 마십시오. ros-controls/ros_controllers [499](https://github.com/ros-controls/ros_controllers/issues/499)에서는 발행을 껐는데도 트리가 계속 번갈아 바뀌었습니다.

# %% [markdown] lang="en" name="view-frames" slide="slide"
# ## What view_frames shows, and what it cannot
#
# [[view_frames]] receives transforms for five seconds and writes a picture and a text: each edge with its rate, its oldest and newest stamp. Without `-o` the files are named after the date. With it they have the name that you give.

# %% [markdown] lang="ko" name="view-frames" slide="slide"
# ## view_frames가 보여 주는 것과 보여 주지 못하는 것
#
# [[view_frames]]는 5초 동안 변환을 모아 그림과 텍스트를 만듭니다. 연결마다 발행률과 가장 오래된 시각, 최신 시각이 나옵니다. `-o` 다음에 파일 이름을 씁니다. `-o`가 없으면 이름에 날짜가 붙습니다.

# %% name="run-view-frames" tags=["interactive"] slide="skip"
folder = lesson.fresh_folder()
# %ros2 run tf2_tools view_frames -o {folder}/frames

# %% [markdown] lang="en" name="six-points" slide="subslide"
# Look at six things in the picture, in the lecture's order (§12):
#
# 1. Is it one connected tree, with one root?
# 2. Is the order `map → odom → base_link` right?
# 3. Does each sensor frame have the right parent?
# 4. Does an unexpected spelling or prefix appear?
# 5. Are the rates and the oldest transforms plausible?
# 6. Does only one node publish each child?
#
# The picture alone cannot answer the sixth. A message on `/tf` does not contain the name of its sender, so `view_frames` prints `Broadcaster: default_authority` for every edge. You see two publishers only in the rate. `ros2 topic info /tf --verbose` lists the nodes that publish `/tf`, though not which edge each of them sends.

# %% [markdown] lang="ko" name="six-points" slide="subslide"
# 그림에서는 여섯 가지를 확인합니다. 강의(§12)의 순서입니다.
#
# 1. 트리가 하나로 연결되어 있고 루트가 하나입니까?
# 2. `map → odom → base_link` 순서가 맞습니까?
# 3. 센서 좌표계마다 부모가 맞습니까?
# 4. 예상하지 못한 철자나 접두사가 있습니까?
# 5. 발행률과 가장 오래된 변환이 정상입니까?
# 6. 자식마다 발행하는 노드가 하나뿐입니까?
#
# 여섯째는 그림만으로 답할 수 없습니다. `/tf` 메시지에는 발행자의 이름이 없어서 어느 연결이나 `Broadcaster: default_authority`라고 나오기 때문입니다. 발행자가 둘이라는 것은 합친 발행률로만 드러납니다. `ros2 topic info /tf --verbose`로 `/tf`에 발행하는 노드들을 알 수 있지만, 어느 연결을 발행하는지는 나오지 않습니다.

# %% [markdown] lang="en" name="checkpoint" slide="slide"
# ## Checkpoint
#
# A robot's tree has two roots, `map` and `odm`. A colleague looks up the laser in `base_link`, both below `odm`. What does tf2 return?
#
# 1. An exception: no lookup works in a broken tree.
# 2. An exception that names `odm`.
# 3. The right answer.
# 4. The right answer, and a warning in the log.
#
# <details><summary>I chose 1</summary>
#
# Each part works by itself. That is why such robots pass so many tests.
#
# </details>
# <details><summary>I chose 2</summary>
#
# The exception names the two frames of a lookup that fails, and this lookup does not fail. The exception of a lookup in `map` would not name `odm` either.
#
# </details>
# <details><summary>I chose 3</summary>
#
# Yes: the path is one step up, from the laser to base_link, and it contains no fault.
#
# </details>
# <details><summary>I chose 4</summary>
#
# There is no warning: tf2 accepts two trees. You notice when a lookup crosses the gap.
#
# </details>

# %% [markdown] lang="ko" name="checkpoint" slide="slide"
# ## 마무리 점검
#
# 어느 로봇의 트리에 루트가 둘 있습니다. `map`과 `odm`입니다. 동료가 `base_link` 기준 레이저의 위치를 조회합니다. 둘 다 `odm` 아래에 있습니다. 결과는 무엇입니까?
#
# 1. 오류입니다. 고장 난 트리에서는 아무 조회도 되지 않습니다.
# 2. `odm`을 알려 주는 오류입니다.
# 3. 맞는 값이 나옵니다.
# 4. 맞는 값이 나오고 로그에 경고가 남습니다.
#
# <details><summary>1번을 골랐습니다</summary>
#
# 나뉜 트리는 저마다 잘 동작합니다. 이런 로봇이 수많은 시험을 통과하는 까닭입니다.
#
# </details>
# <details><summary>2번을 골랐습니다</summary>
#
# 오류 메시지에는 실패한 조회의 두 이름이 나오는데, 이 조회는 실패하지 않습니다. 실패하는 조회에서도 `odm`은 나오지 않습니다.
#
# </details>
# <details><summary>3번을 골랐습니다</summary>
#
# 맞습니다. 레이저에서 base_link로 한 단계 올라가며, 그 경로에는 고장이 없습니다.
#
# </details>
# <details><summary>4번을 골랐습니다</summary>
#
# 경고는 나오지 않습니다. 트리가 둘이어도 tf2는 동작합니다. 두 트리에 걸친 조회를 하면 그때 오류가 납니다.
#
# </details>

# %% [markdown] lang="en" name="on-the-robot" slide="slide"
# ## On a real robot
#
# ```
# ros2 run tf2_tools view_frames -o frames      # frames.pdf and frames.gv, from five seconds
# ros2 topic info /tf --verbose                 # which nodes send on /tf
# ros2 param get /robot_state_publisher frame_prefix
# ```
#
# `view_frames` sees only its five seconds, and only the newest parent of each child. A fault that comes and goes needs a program that keeps looking. Save this one as `tree_watcher.py`. It keeps the dict of this page, reports each child whose parent changes, and prints the roots:
#
# ```python
# # tf_lab_py/tree_watcher.py
# import rclpy
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.qos import DurabilityPolicy, QoSProfile
# from tf2_msgs.msg import TFMessage
#
#
# class TreeWatcher(Node):
#     def __init__(self):
#         super().__init__('tree_watcher')
#         self.parent_of = {}
#         kept = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
#         self.create_subscription(TFMessage, '/tf', self.on_edges, 100)
#         self.create_subscription(TFMessage, '/tf_static', self.on_edges, kept)
#         self.create_timer(2.0, self.report)
#
#     def on_edges(self, message):
#         for edge in message.transforms:
#             child, parent = edge.child_frame_id, edge.header.frame_id
#             before = self.parent_of.get(child, parent)
#             if parent != before:
#                 self.get_logger().error(f'{child}: child of {before}, now of {parent}')
#             self.parent_of[child] = parent
#
#     def report(self):
#         roots = sorted(set(self.parent_of.values()) - set(self.parent_of))
#         if len(roots) == 1:
#             self.get_logger().info(f'{len(self.parent_of)} edges, one root: {roots[0]}')
#         else:
#             self.get_logger().warning(f'{len(self.parent_of)} edges, roots: {roots}')
#
#
# def main():
#     rclpy.init()
#     node = TreeWatcher()
#     try:
#         rclpy.spin(node)
#     except (KeyboardInterrupt, ExternalShutdownException):
#         pass
#     finally:
#         node.destroy_node()
#         rclpy.try_shutdown()
#
#
# if __name__ == '__main__':
#     main()
# ```
#
# Run it on a robot with `python3 tree_watcher.py`. Without ROS, type this into a terminal of JupyterLab, to see it report that the parent of `base_link` changes:
#
# ```
# tflab run tree_watcher.py --for 5 \
#     --with "ros2 run tf2_ros static_transform_publisher --frame-id odom --child-frame-id base_link" \
#     --with "ros2 run tf2_ros static_transform_publisher --frame-id odm --child-frame-id base_link"
# ```

# %% [markdown] lang="ko" name="on-the-robot" slide="slide"
# ## 실제 로봇에서
#
# ```
# ros2 run tf2_tools view_frames -o frames      # 5초 동안 변환을 모아 frames.pdf와 frames.gv를 만듭니다
# ros2 topic info /tf --verbose                 # /tf에 발행하는 노드를 모두 보여 줍니다
# ros2 param get /robot_state_publisher frame_prefix
# ```
#
# `view_frames`는 5초 동안만 수신하고, 자식마다 가장 최근의 부모만 보여 줍니다. 가끔 일어나는 고장을 잡으려면 계속 지켜보는 프로그램이 필요합니다. 아래를 `tree_watcher.py`로 저장해 보세요. 이 장의 dict를 그대로 쓰며, 부모가 바뀐 자식을 알리고 루트를 출력합니다.
#
# ```python
# # tf_lab_py/tree_watcher.py
# import rclpy
# from rclpy.executors import ExternalShutdownException
# from rclpy.node import Node
# from rclpy.qos import DurabilityPolicy, QoSProfile
# from tf2_msgs.msg import TFMessage
#
#
# class TreeWatcher(Node):
#     def __init__(self):
#         super().__init__('tree_watcher')
#         self.parent_of = {}
#         kept = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
#         self.create_subscription(TFMessage, '/tf', self.on_edges, 100)
#         self.create_subscription(TFMessage, '/tf_static', self.on_edges, kept)
#         self.create_timer(2.0, self.report)
#
#     def on_edges(self, message):
#         for edge in message.transforms:
#             child, parent = edge.child_frame_id, edge.header.frame_id
#             before = self.parent_of.get(child, parent)
#             if parent != before:
#                 self.get_logger().error(f'{child}: child of {before}, now of {parent}')
#             self.parent_of[child] = parent
#
#     def report(self):
#         roots = sorted(set(self.parent_of.values()) - set(self.parent_of))
#         if len(roots) == 1:
#             self.get_logger().info(f'{len(self.parent_of)} edges, one root: {roots[0]}')
#         else:
#             self.get_logger().warning(f'{len(self.parent_of)} edges, roots: {roots}')
#
#
# def main():
#     rclpy.init()
#     node = TreeWatcher()
#     try:
#         rclpy.spin(node)
#     except (KeyboardInterrupt, ExternalShutdownException):
#         pass
#     finally:
#         node.destroy_node()
#         rclpy.try_shutdown()
#
#
# if __name__ == '__main__':
#     main()
# ```
#
# 로봇에서는 `python3 tree_watcher.py`로 실행합니다. ROS가 없으면 JupyterLab의 터미널에 다음을 입력해 보세요. `base_link`의 부모가 바뀌었다고 알립니다.
#
# ```
# tflab run tree_watcher.py --for 5 \
#     --with "ros2 run tf2_ros static_transform_publisher --frame-id odom --child-frame-id base_link" \
#     --with "ros2 run tf2_ros static_transform_publisher --frame-id odm --child-frame-id base_link"
# ```

# %% [markdown] lang="en" name="recap" slide="slide"
# ## What to keep
#
# - TF is a dict, child → parent. A lookup goes up from its source to the first common frame, and down to its target: a [[path]].
# - One [[root]] means a tree, two mean a gap, none means a loop. `set(parents) - set(children)` gives the roots.
# - tf2 checks no rule when a transform is sent. Only lookups fail. In two trees, lookups across the gap fail, and the error names only the frames of the lookup. In a loop, a lookup fails if its target is not above its source.
# - A child that is sent with another parent moves. If an edge has two publishers, the tree keeps its shape, and the value alternates. Look at the rate.
# - Names are strings. Use no slash in front, and give every frame that belongs to one robot its [[frame prefix]]. Decide whether `map` is shared.

# %% [markdown] lang="ko" name="recap" slide="slide"
# ## 정리
#
# - TF는 자식 → 부모로 된 dict입니다. 조회는 원본에서 두 경로가 만날 때까지 올라갔다가 목표로 내려갑니다. 이것이 [[path|경로]]입니다.
# - [[root|루트]]가 하나면 트리, 둘이면 끊긴 것, 없으면 고리입니다. `set(부모들) - set(자식들)`로 알 수 있습니다.
# - 변환을 발행할 때 tf2는 규칙을 확인하지 않습니다. 조회할 때에만 실패합니다. 트리가 둘이면 끊긴 곳을 지나는 조회가 실패하고, 오류 메시지에는 조회의 두 이름만 나옵니다. 고리가 있으면 목표가 원본의 위쪽에 있지 않은 조회가 실패합니다.
# - 같은 자식을 다른 부모로 발행하면 부모가 바뀝니다. 한 연결을 둘이 발행하면 모양은 그대로인 채 값만 번갈아 바뀝니다. 발행률을 보십시오.
# - 이름은 문자열입니다. 앞에 슬래시를 쓰지 않고, 한 로봇에 속한 것에는 모두 [[frame prefix|접두사]]를 붙입니다. `map`을 함께 쓸지는 미리 정합니다.

# %% [markdown] lang="en" name="exit-ticket" slide="slide"
# ## Exit ticket
#
# > `lookup_transform('map', 'gripper', …)` fails with "not part of the same tree"; yesterday it worked. Name the one thing that you look at first, and what you hope to see there.
#
# <details><summary>Compare</summary>
#
# Look at the roots, with `view_frames` or one line of Python. You hope to see two names. The unexpected one is the misspelt parent, or a frame whose own edge is no longer published.
#
# </details>

# %% [markdown] lang="ko" name="exit-ticket" slide="slide"
# ## 마무리하며
#
# > 어제까지 되던 `lookup_transform('map', 'gripper', …)`이 "not part of the same tree" 오류로 실패합니다. 가장 먼저 볼 것 하나와, 거기에서 찾는 것을 말해 보세요.
#
# <details><summary>맞춰 보기</summary>
#
# 루트입니다. `view_frames`나 파이썬 한 줄로 봅니다. 이름이 둘이면 예상하지 못한 이름을 찾습니다. 그것은 잘못 적힌 부모이거나, 위로 가는 연결의 발행자가 사라진 좌표계입니다.
#
# </details>

# %% [markdown] lang="en" name="exit-ticket-notes" slide="notes"
# Two minutes on paper.
# Sort the answers: roots, the error text, restart.
# Begin the next lecture with the third kind.

# %% [markdown] lang="ko" name="exit-ticket-notes" slide="notes"
# 종이에 2분 동안 씁니다.
# 루트, 오류 메시지, 재시작의 세 더미로 나눕니다.
# 셋째 더미로 다음 강의를 시작합니다.

# %% [markdown] lang="en" name="core-end" slide="skip"
# ## Enough to go on
#
# You can now find a path by hand, tell one tree from two or from a loop, and say what tf2 checks and which lookups fail.
# Practise that in [E4 The tree of frames](../../exercises/en/E04_frame_tree.ipynb). Tasks E4.2 and E4.6 count for two lines of the checklist that `tflab progress` shows: *I have drawn the tree with view_frames*, and *I have found a second broadcaster of one child*.
# In the next chapter, [05 map, odom, base_link](05_map_odom_base_link.ipynb), "one parent each" decides which node may publish the robot's pose.
#
# The sections below are for the curious and for practice. Each heading says what it holds. Open one when you need it.

# %% [markdown] lang="ko" name="core-end" slide="skip"
# ## 여기까지면 충분합니다
#
# 이제 경로를 손으로 찾고, 하나인 트리와 둘로 나뉜 트리, 고리를 구별하며, tf2가 무엇을 확인하고 어떤 조회가 실패하는지 말할 수 있습니다.
# 연습 문제 [E4 좌표계 트리](../../exercises/ko/E04_frame_tree.ipynb)에서 손에 익혀 보세요. 과제 E4.2와 E4.6은 실습 체크리스트(00장의 *나의 학습 현황*에 있습니다)의 두 줄에 해당합니다. “view_frames로 트리 그림을 만들었습니다”와 “같은 자식을 발행하는 중복 발행자를 찾아 제거했습니다”입니다.
# 다음 장 [05 map, odom, base_link](05_map_odom_base_link.ipynb)에서는 “부모는 하나씩”이라는 규칙에 따라 어느 노드가 로봇의 포즈를 발행할지 정합니다.
#
# 아래는 더 알고 싶거나 더 연습하고 싶을 때 읽는 절입니다. 제목에 내용이 드러나 있으니 필요할 때 펼쳐 보세요.

# %% [markdown] lang="en" name="plaster-heading" slide="subslide"
# ## The quick workaround for a typo, and why it is no fix

# %% [markdown] lang="ko" name="plaster-heading" slide="subslide"
# ## 오타를 덮는 임시방편, 왜 해결이 아닐까요?

# %% [markdown] lang="en" name="plaster"
# For the tree with the typo `odm`, forums suggest one more static edge, `odom → odm`, with all values zero. It works.

# %% [markdown] lang="ko" name="plaster"
# 앞에서 본 오타 `odm`을 두고 인터넷 게시글에서는 값이 모두 0인 정적 연결 `odom → odm`을 하나 더 발행하라고들 합니다. 동작은 합니다.

# %% name="plastered" tags=["collapsed"] slide="-"
# Draw the path with the workaround.
send(island, "odom", "odm", x=0.0)
lesson.draw_walk(island, "map", "laser_frame")

# %% [markdown] lang="en" name="plastered-seen"
# But one frame has two names now. As soon as another program publishes `odom → base_link`, spelt correctly, `base_link` is no longer a child of `odm`. Fix the name where it is written.

# %% [markdown] lang="ko" name="plastered-seen"
# 하지만 이제 같은 위치에 이름이 둘입니다. 언젠가 다른 프로그램이 철자를 맞게 써서 `odom → base_link`를 발행하면, base는 `odm`에서 떨어져 나갑니다. 이름은 잘못 적힌 곳에서 고치십시오.

# %% [markdown] lang="en" name="plaster-notes" slide="notes"
# Who has used such a workaround?
# Do not blame anybody; ask what would have to happen for it to fail.
# One correct line in another program is enough.

# %% [markdown] lang="ko" name="plaster-notes" slide="notes"
# 이런 임시방편을 써 본 사람이 있는지 묻습니다.
# 탓하지 않습니다.
# 무슨 일이 생기면 다시 고장 날지 묻습니다.
# 다른 프로그램에 맞는 철자 한 줄이면 됩니다.

# %% [markdown] lang="en" name="two-robots-heading" slide="slide"
# ## Two robots, and an `odom` without a prefix

# %% [markdown] lang="ko" name="two-robots-heading" slide="slide"
# ## 로봇 두 대, 그리고 접두사가 없는 `odom`

# %% [markdown] lang="en" name="two-robots"
# A second robot is placed beside the first. Its frames have a prefix, as in `robot2/base_footprint`. Somebody forgot to prefix `odom`.

# %% [markdown] lang="ko" name="two-robots"
# 두 번째 로봇을 옆에 둡니다. 좌표계에는 모두 `robot2/base_footprint`처럼 접두사를 붙였습니다. 그런데 `odom`에는 붙이지 않았습니다.

# %% name="a-fleet" tags=["collapsed"] slide="skip"
# Define start_two(), which starts both robots.
graph.stop()
listener.unregister()
tf_buffer = Buffer()  # a new one, without the frames of the first robot
listener = TransformListener(tf_buffer, node, spin_thread=True)

def start_two(shared, apart_s):
    graph.stop()
    first = lesson.TeachingRobot(lesson.Drive(start_ns=graph.now_ns), prefix="robot1/", shared=shared)
    other_start = lesson.Drive(start=lesson.PlanarPose(4.0, -1.0, 1.2), start_ns=graph.now_ns)
    second = lesson.TeachingRobot(other_start, prefix="robot2/", shared=shared, seed=1)
    lesson.launch(graph, first, only=["wheel_odometry", "localization"])
    graph.run(seconds=apart_s)
    lesson.launch(graph, second, only=["wheel_odometry", "localization"])
    graph.run(seconds=3.0)

# %% [markdown] lang="en" name="one-odom-predict"
# The two robots are three metres apart, and drive the same laps. The second was started 30 ms after the first. **Predict:** what do you see if you look up `robot2/base_footprint` in `map` fifty times a second? And if both were started at the same time?

# %% [markdown] lang="ko" name="one-odom-predict"
# 두 로봇은 3미터 떨어진 곳에서 출발해 모양이 같은 경로를 달립니다. 두 번째 로봇은 30 ms 나중에 출발했습니다. **예측해 봅시다.** `map` 기준의 `robot2/base_footprint`를 1초에 쉰 번 조회하면 무엇이 보일까요? 둘이 동시에 출발했다면 어떨까요?

# %% name="one-odom" tags=["predicted"] slide="-"
def look(times=343):
    leaps, largest, before = 0, 0.0, place("map", "robot2/base_footprint")
    for _ in range(times):
        graph.run(seconds=0.02)
        here = place("map", "robot2/base_footprint")
        step, before = math.dist(before, here), here
        leaps, largest = leaps + (step > 0.5), max(largest, step)
    x, y = place("robot1/base_footprint", "robot2/base_footprint")
    print(f"{leaps} leaps in {times} looks, largest {largest:.2f} m; robot2 in robot1 at ({x:.2f}, {y:.2f}) m")


for apart_s in (0.03, 0.0):
    start_two(("map", "odom"), apart_s)
    look()

# %% [markdown] lang="en" name="one-odom-seen" tags=["predicted"]
# Either way `odom` has two publishers. Started 30 ms apart, robot2 jumps by more than two metres, again and again. Started together, nothing jumps: the two messages for `odom` have the same stamp. A buffer stores both, and answers with the one that came last. But both robots are children of *one* odom, and the odometry of each starts at zero there. TF places robot2 inside robot1, without an error, and a collision check reports a crash that never happened.

# %% [markdown] lang="ko" name="one-odom-seen" tags=["predicted"]
# 두 경우 모두 `odom`의 발행자는 둘입니다. 따로 출발하면 robot2는 2미터 넘게 거듭 튑니다. 동시에 출발하면 아무것도 튀지 않습니다. `odom`을 담은 두 메시지의 측정 시각이 같고, 버퍼는 둘 다 보관하면서 마지막에 받은 값을 반환하기 때문입니다. 하지만 두 로봇은 *한* odom 아래에 있고, 저마다 바퀴의 회전을 0부터 셉니다. TF에서 robot2는 아무 오류 없이 robot1과 겹쳐 있습니다. 충돌을 검사하는 노드는 일어나지도 않은 충돌을 보고합니다.

# %% [markdown] lang="en" name="fleet-notes" slide="notes"
# The second run is the worse one, because nothing jumps.
# Ask which alarm would go off.
# None.
# Then ask which frame belongs to both robots: map, and only map.

# %% [markdown] lang="ko" name="fleet-notes" slide="notes"
# 더 나쁜 것은 둘째 경우입니다.
# 아무것도 튀지 않기 때문입니다.
# 어떤 경보가 울릴지 묻습니다.
# 없습니다.
# 두 로봇이 함께 쓰는 것은 무엇인지 묻습니다. 답은 map, 오직 map입니다.

# %% name="between-robots" tags=["collapsed"] slide="-"
# Draw the path.
lesson.draw_walk(tf_buffer, "robot1/base_footprint", "robot2/base_footprint")

# %% [markdown] lang="en" name="between-robots-seen"
# The shape is a correct tree, and the path from one robot to the other has two steps, through the `odom` that belongs to neither.

# %% [markdown] lang="ko" name="between-robots-seen"
# 모양은 정상적인 트리이고, 두 로봇 사이의 경로는 두 단계입니다. 어느 로봇에도 속하지 않는 `odom`을 지나갑니다.

# %% [markdown] lang="en" name="prefixed" slide="subslide"
# The fix: every frame of one robot carries its prefix, `odom` too. Only the frame that both share, `map`, has none.

# %% [markdown] lang="ko" name="prefixed" slide="subslide"
# 고치는 방법은 이렇습니다. 한 로봇에 속한 것에는 `odom`까지 모두 접두사를 붙입니다. 둘이 같은 것을 뜻하는 `map`만 그대로 둡니다.

# %% name="two-odoms" slide="-"
start_two(("map",), 0.03)
look()

# %% name="two-odoms-tree" tags=["collapsed"] slide="-"
# Show each edge with its rate and its publishers.
lesson.frame_tree(graph, seconds=2.0)

# %% [markdown] lang="en" name="two-odoms-seen"
# The robots are in their true positions, now two and a half metres apart. No step is larger than the distance driven in a tenth of a second. A latest transform is only as new as the slowest edge on its path, and `map → robot2/odom` is published at 10 Hz.
# In a real launch file this is a parameter in many places: `frame_prefix` of robot_state_publisher, the frames of the odometry, of the localisation, of each sensor driver, and RViz's Fixed Frame. If you forget one, the robots share a frame or lookups fail.

# %% [markdown] lang="ko" name="two-odoms-seen"
# 이제 두 로봇은 실제로 있는 곳에 있고, 튀지도 않습니다. 가장 큰 변화는 0.1초 동안 달린 거리쯤입니다. 최신 변환을 조회하면 두 연결에 모두 값이 있는 가장 최근 시각의 변환이 나옵니다. 그 시각은 10 Hz로 발행되는 `map → robot2/odom`이 정합니다.
# 실제 launch 파일에서는 여러 곳의 파라미터를 고쳐야 합니다. robot_state_publisher의 `frame_prefix`, 오도메트리와 위치 추정의 좌표계 이름, 센서 드라이버마다의 좌표계 이름, RViz의 고정 좌표계(Fixed Frame)입니다. 하나라도 빠뜨리면 두 로봇의 좌표계가 섞이거나 조회가 실패합니다.

# %% name="stop" tags=["collapsed"] slide="skip"
# Stop the nodes.
graph.stop()
node.destroy_node()
rclpy.shutdown()

# %% [markdown] lang="en" name="from-before-heading" slide="subslide"
# ## Three questions from earlier chapters

# %% [markdown] lang="ko" name="from-before-heading" slide="subslide"
# ## 앞 장 복습: 세 문제

# %% [markdown] lang="en" name="from-before"
# 1. What are the three parts of a usable measurement, and which one does this chapter leave out?
# 2. `camera_T_laser` is `camera_T_base @ base_T_laser`. Which of the two was published as it is, and which is an inverse?
# 3. In the message of an edge, which field names the parent?
#
# <details><summary>Answers</summary>
#
# 1. Value, frame, stamp. This chapter leaves out the stamp. Chapter 08 uses it, and each edge then has a history.
# 2. `base_T_laser` was published; `camera_T_base` is the inverse of the published edge, base → camera.
# 3. `header.frame_id`; the child is in `child_frame_id`.
#
# </details>

# %% [markdown] lang="ko" name="from-before"
# 1. 측정값에 꼭 필요한 세 가지는 무엇이고, 이 장에서 뺀 것은 무엇입니까?
# 2. `camera_T_laser`는 `camera_T_base @ base_T_laser`입니다. 발행된 그대로인 것은 무엇이고 역변환인 것은 무엇입니까?
# 3. 연결의 메시지에서 부모는 어느 필드에 있습니까?
#
# <details><summary>답</summary>
#
# 1. 값, 좌표계, 측정 시각입니다. 뺀 것은 측정 시각입니다. 08장에서 다시 나오며, 그때는 연결마다 지난 기록이 생깁니다.
# 2. `base_T_laser`는 발행된 그대로이고, `camera_T_base`는 발행된 연결 base → camera의 역변환입니다.
# 3. `header.frame_id`입니다. 자식은 `child_frame_id`에 있습니다.
#
# </details>

# %% [markdown] lang="en" name="practice-heading" slide="subslide"
# ## Practice question · Q4

# %% [markdown] lang="ko" name="practice-heading" slide="subslide"
# ## 서술형 문제 · Q4

# %% [markdown] lang="en" name="practice"
# What symptoms may appear when two nodes publish the same child in a TF tree? Write three or four sentences.
#
# <details><summary>What a full answer contains</summary>
#
# - [ ] tf2 raises no error when a transform is sent: both are stored.
# - [ ] With one parent, values alternate: the robot trembles or jumps in RViz. The jumps grow as the values of the two publishers drift apart.
# - [ ] With two parents, the child alternates between two positions in the tree, and some lookups fail.
# - [ ] It shows in a rate that is the sum of both, and in the list of publishers, not in the shape of the tree.
# - [ ] The fix is to choose one publisher, and to switch the other off.
#
# </details>

# %% [markdown] lang="ko" name="practice"
# TF 트리에서 같은 자식을 두 노드가 발행하면 어떤 증상이 나타날 수 있습니까? 서너 문장으로 써 보세요.
#
# <details><summary>완전한 답에 들어 있는 것</summary>
#
# - [ ] 변환을 발행할 때 tf2는 오류를 내지 않습니다. 둘 다 저장됩니다.
# - [ ] 부모가 같으면 값이 번갈아 나옵니다. RViz에서 로봇이 떨거나 튀고, 둘의 차이가 벌어질수록 심해집니다.
# - [ ] 부모가 다르면 자식이 트리의 두 곳을 오가고, 조회가 번갈아 실패합니다.
# - [ ] 트리의 모양이 아니라, 둘을 합친 발행률과 발행자 목록에서 드러납니다.
# - [ ] 발행 책임을 한 노드에 맡기고 다른 쪽은 끕니다.
#
# </details>
