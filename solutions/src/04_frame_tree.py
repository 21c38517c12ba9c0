# %% [markdown] lang="en" name="title"
# # Exercises 04 · The tree of frames
#
# Seven tasks, 24 points, about 60 minutes. The page they belong to: [04 · The tree of frames](../../notebooks/en/04_frame_tree.ipynb)
#
# Write your answer where it says `...` or `your turn`, run the cell, then run the check below it.
# The reply to a wrong answer names the mistake. `hint("E4.1")` gives the first of three hints.
# After a pass, or three tries, `solution("E4.1")` shows a solution. To start over, delete this file and type `tflab lab` in a terminal.
# Your frames come from `task(...)` and may differ from your neighbour's.

# %% [markdown] lang="ko" name="title"
# # 연습 문제 04 · 좌표계 트리
#
# 과제 일곱 개, 24점, 약 60분입니다. 함께 보는 페이지: [04 · 좌표계 트리](../../notebooks/ko/04_frame_tree.ipynb)
#
# `...`이나 `your turn`이라고 적힌 자리에 답을 쓰고 셀을 실행한 다음, 아래의 확인 셀을 실행해 보세요.
# 틀린 답을 내면 어떤 실수로 보이는지 알려 줍니다. `hint("E4.1")`은 세 힌트 가운데 첫 번째를 보여 줍니다.
# 통과하거나 세 번 시도한 뒤에는 `solution("E4.1")`로 풀이를 볼 수 있습니다. 처음부터 다시 하려면 이 파일을 지우고 터미널에서 `tflab lab`을 입력해 보세요.
# 좌표계는 `task(...)`가 주며 옆 사람과 다를 수 있습니다.

# %% name="load"
# %load_ext tflab
from tflab.workbook import call, check, hint, solution, task

# %% name="imports"
from difflib import get_close_matches

from tf2_ros import ConnectivityException

# %% [markdown] lang="en" name="e4-1"
# ## E4.1 · One missing letter (3 points)
#
# `e4_1.edges` are the edges of a robot as in `frames.gv`, pairs (parent, child). One of the names is misspelt in one place, so there are two trees.
# Give the corrected tree as a dict, child → parent, with all its edges. You may type the dict by hand or compute it. `get_close_matches(word, names, n=1)` of Python's `difflib` returns a list with the most similar name.

# %% [markdown] lang="ko" name="e4-1"
# ## E4.1 · 한 글자가 모자랍니다 (3점)
#
# `e4_1.edges`는 로봇의 연결을 `view_frames`의 출력 `frames.gv`에서 옮겨 적은 것입니다. 연결마다 (부모, 자식) 쌍 하나입니다. 이름 하나가 한 곳에서 잘못 적혀 트리가 둘로 나뉘었습니다.
# 고친 트리를 자식 → 부모로 된 dict로 답하십시오. 연결이 모두 들어 있어야 합니다. 눈으로 읽고 직접 써도 되고 계산해도 됩니다. 파이썬 `difflib`의 `get_close_matches(word, names, n=1)`은 `names`에서 `word`와 가장 비슷한 이름 하나를 리스트에 담아 반환합니다.

# %% name="e4-1-given"
e4_1 = task("E4.1")

# %% name="e4-1-answer" tags=["answer"]
# The check reads `corrected` alone; the three before it are one way there.
# BEGIN SOLUTION
told = {child: parent for parent, child in e4_1.edges}  # every edge as it was heard, child -> parent
(misspelt,) = set(told.values()) - set(told) - {"map"}  # the name that is wrong
(meant,) = get_close_matches(misspelt, told, n=1)  # the name that it should be
corrected = {child: meant if parent == misspelt else parent for child, parent in told.items()}  # {"odom": "map", …}
# END SOLUTION

# %% name="e4-1-check" tags=["check"]
check("E4.1", corrected)

# %% [markdown] lang="en" name="e4-2"
# ## E4.2 · Five listings (5 points)
#
# `e4_2.a` to `e4_2.e` each list what was received on a robot: rows (parent, child, node). For each letter:
#
# - `"a"`: `"healthy"`, `"two trees"`, `"loop"`, `"two parents"` or `"two owners"` (two nodes send the same edge);
# - `"a child"`: the name of the child at fault. It is the child that has a misspelt parent, two parents, or two owners. For a healthy robot and for a loop, write `"none"`.
#
# The answer cell gives each of these words a name, so that you need not type it: `"a": two_trees`. Write only the names of children in quotes. The next cell prints the listings; you only need to read them.

# %% [markdown] lang="ko" name="e4-2"
# ## E4.2 · 목록 다섯 개 (5점)
#
# `e4_2.a`부터 `e4_2.e`까지는 로봇 다섯 대에서 받은 변환을 각각 적은 목록입니다. 각 줄은 (부모, 자식, 노드)입니다. 목록마다 두 가지를 답하십시오.
#
# - `"a"`: `"healthy"`(정상), `"two trees"`(트리가 둘), `"loop"`(고리), `"two parents"`(부모가 둘), `"two owners"`(한 연결을 두 노드가 발행) 가운데 하나.
# - `"a child"`: 문제의 자식. 잘못 적힌 부모 아래에 있거나, 부모가 둘이거나, 발행하는 노드가 둘인 자식입니다. 정상인 로봇과 고리에는 `"none"`이라고 쓰십시오.
#
# 답 셀에는 이 문구들이 변수로 준비되어 있습니다. `"a": two_trees`처럼 변수를 쓰고, 자식의 이름만 문자열로 쓰십시오. 아래 셀이 목록을 출력하므로 읽고 답하면 됩니다.

# %% name="e4-2-given"
e4_2 = task("E4.2")

# %% name="e4-2-answer" tags=["answer"]
healthy, two_trees, loop, two_parents, two_owners, none = "healthy", "two trees", "loop", "two parents", "two owners", "none"
finding = {"a": ..., "a child": ..., "b": ..., "b child": ..., "c": ..., "c child": ...,
           "d": ..., "d child": ..., "e": ..., "e child": ...}
# BEGIN SOLUTION
_listings = vars(e4_2)
for letter, rows in _listings.items():
    parents = {child: {p for p, c, _ in rows if c == child} for _, child, _ in rows}
    faults = {two_parents: [child for child in parents if len(parents[child]) > 1],
              two_owners: [child for child in parents if len({n for _, c, n in rows if c == child}) > 1],
              loop: [child for child in parents if any(child in parents.get(p, ()) for p in parents[child])],
              two_trees: [child for child in parents if not parents[child] & {*parents, "map"}]}
    kind, at_fault = next(((kind, found[0]) for kind, found in faults.items() if found), (healthy, none))
    finding[letter], finding[f"{letter} child"] = kind, none if kind == loop else at_fault
# END SOLUTION

# %% name="e4-2-check" tags=["check"]
check("E4.2", finding)

# %% [markdown] lang="en" name="e4-3"
# ## E4.3 · Up, then down (5 points)
#
# `parent_of` is a tree without loops, a dict child → parent. Return the shortest list of steps from `source` to `target`. Each step is a pair (child, `"up"`) or (child, `"down"`), named after the child of its edge.
# From a frame to itself there is no step: return an empty list. If there is no path, raise `ConnectivityException`.

# %% [markdown] lang="ko" name="e4-3"
# ## E4.3 · 올라갔다가 내려갑니다 (5점)
#
# `parent_of`는 고리가 없는 트리이며, 자식 → 부모로 된 dict입니다. 원본 `source`에서 목표 `target`까지 꼭 필요한 단계만 반환하십시오. (자식, `"up"`)이나 (자식, `"down"`) 쌍의 리스트이고, 단계마다 그 연결의 자식 이름을 씁니다.
# 원본과 목표가 같으면 빈 리스트를 반환하십시오. 경로가 없으면 `ConnectivityException`을 일으키십시오.


# %% name="e4-3-answer" tags=["answer"]
def path(parent_of, target, source):
    """Return the steps from source to target: [(child, "up" or "down"), ...]."""
    # BEGIN SOLUTION

    def way_up(frame):
        return [frame, *(way_up(parent_of[frame]) if frame in parent_of else [])]

    up, down = way_up(source), way_up(target)
    met = next((frame for frame in up if frame in down), None)
    if met is None:
        raise ConnectivityException(f"{source} and {target} are not part of the same tree")
    down = down[: down.index(met)]
    return [(child, "up") for child in up[: up.index(met)]] + [(child, "down") for child in reversed(down)]
    # END SOLUTION


# %% name="e4-3-check" tags=["check"]
check("E4.3", path)

# %% [markdown] lang="en" name="e4-4"
# ## E4.4 · Two robots, one map (3 points)
#
# `e4_4.edges` is the tree of one robot, pairs (parent, child), without prefixes. Two such robots follow the contract of one shared `map`: they share `map`, and no other frame. `e4_4.prefixes` contains their names.
# Give the tree of both together as a dict, child → parent. A frame of the first robot is named as in `robot1/odom`.

# %% [markdown] lang="ko" name="e4-4"
# ## E4.4 · 로봇 두 대, 지도 하나 (3점)
#
# `e4_4.edges`는 로봇 한 대의 트리이며, 접두사가 없는 (부모, 자식) 쌍입니다. 이런 로봇 두 대가 `map` 하나를 함께 쓴다고 가정합니다. 나머지는 따로 씁니다. `e4_4.prefixes`는 두 로봇의 이름입니다.
# 둘을 합친 트리를 자식 → 부모로 된 dict로 답하십시오. 좌표계 이름은 `robot1/odom`과 같은 꼴입니다.

# %% name="e4-4-given"
e4_4 = task("E4.4")

# %% name="e4-4-answer" tags=["answer"]
# BEGIN SOLUTION
fleet = {}  # child -> parent, of both robots: {"robot1/odom": "map", …}
for robot in e4_4.prefixes:
    for parent, child in e4_4.edges:
        fleet[f"{robot}/{child}"] = parent if parent == "map" else f"{robot}/{parent}"
# END SOLUTION

# %% name="e4-4-check" tags=["check"]
check("E4.4", fleet)

# %% [markdown] lang="en" name="e4-5"
# ## E4.5 · What happens to this name? (3 points)
#
# `e4_5.lines` has eight lines, a to h. Each line is a transform that a node sends (parent → child), or a lookup. `fates` is a dict with the eight letters. For each, choose one of these:
#
# - `"kept as odom"`: it is stored, and found as `odom`
# - `"another frame"`: it is stored under a name that is not `odom`
# - `"refused when sent"`: nothing is stored
# - `"refused when asked"`: the lookup itself is malformed
# - `"shared by accident"`: two robots use one name for two frames

# %% [markdown] lang="ko" name="e4-5"
# ## E4.5 · 이 이름은 어떻게 될까요? (3점)
#
# `e4_5.lines`에는 a부터 h까지 여덟 줄이 있습니다. 노드가 발행하는 것(부모 → 자식)이거나 누군가 조회하는 것입니다. `fates`는 여덟 글자를 키로 하는 dict입니다. 글자마다 답하십시오.
#
# - `"kept as odom"`: 저장되고 `odom`으로 조회할 수 있습니다
# - `"another frame"`: `odom`이 아닌 다른 이름으로 저장됩니다
# - `"refused when sent"`: 아무것도 저장되지 않습니다
# - `"refused when asked"`: 조회의 인자가 잘못되었습니다
# - `"shared by accident"`: 로봇 둘이 같은 이름을 서로 다른 좌표계에 씁니다

# %% name="e4-5-given"
e4_5 = task("E4.5")
# The form: fates = {"a": "kept as odom", "b": "another frame", and so on, to "h"}; the words are only an example.


# %% name="e4-5-answer" tags=["answer"]
# BEGIN SOLUTION
fates = {
    letter: {
        "send '/odom' -> 'base_link'": "kept as odom",
        "send 'Odom' -> 'base_link'": "another frame",
        "send '//odom' -> 'base_link'": "another frame",
        "send '' -> 'base_link'": "refused when sent",
        "send 'odom' -> 'odom'": "refused when sent",
        "ask lookup_transform('/odom', 'base_link', Time())": "refused when asked",
        "robot1 and robot2 both send 'map' -> 'odom'": "shared by accident",
        "robot1 and robot2, each in a namespace of its own, both send 'odom' -> 'base_link'": "shared by accident",
    }[line]
    for letter, line in e4_5.lines.items()
}
# END SOLUTION

# %% name="e4-5-check" tags=["check"]
check("E4.5", fates)

# %% [markdown] lang="en" name="e4-6"
# ## E4.6 · Which children have several owners? (3 points)
#
# `log` has a row (node, parent, child) for each transform that was received. Return the children that are sent by two nodes or more, sorted by name. A child to which two nodes give different parents counts, too. A node that sends the same child several times counts once, even with different parents.

# %% [markdown] lang="ko" name="e4-6"
# ## E4.6 · 발행하는 노드가 여럿인 것은? (3점)
#
# `log`에는 받은 변환마다 (노드, 부모, 자식) 한 줄이 있습니다. 둘 이상의 노드가 발행하는 자식을 이름 순서로 반환하십시오. 두 노드가 서로 다른 부모로 발행한 자식도 셉니다. 한 노드가 여러 번 발행한 것은 부모가 달라도 한 번으로 셉니다.


# %% name="e4-6-answer" tags=["answer"]
def several_owners(log):
    """Return the children with two or more nodes, sorted."""
    # BEGIN SOLUTION
    nodes = {}
    for node, _, child in log:
        nodes.setdefault(child, set()).add(node)
    return sorted(child for child in nodes if len(nodes[child]) > 1)
    # END SOLUTION


# %% name="e4-6-check" tags=["check"]
check("E4.6", several_owners)

# %% [markdown] lang="en" name="e4-7"
# ## E4.7 · The line that the dog needed (2 points)
#
# Return the full name of a frame. `prefix` is a robot's name. It can be empty or have slashes around it. `name` is a frame, possibly with a slash in front. The result never begins with a slash and never contains two in a row. The robots share one `map`, so `map` has no prefix.

# %% [markdown] lang="ko" name="e4-7"
# ## E4.7 · 로봇 개에게 필요했던 한 줄 (2점)
#
# 좌표계의 전체 이름을 반환하십시오. `prefix`는 로봇 이름이며 앞뒤에 슬래시가 있거나 비어 있을 수 있습니다. `name`은 좌표계이며 앞에 슬래시가 있을 수 있습니다. 결과는 슬래시로 시작하지 않고, 슬래시가 둘 나란히 있지도 않습니다. 로봇들이 `map` 하나를 함께 쓴다고 가정하므로 `map`에는 접두사가 없습니다.


# %% name="e4-7-answer" tags=["answer"]
def frame_name(prefix, name):
    """Return the full name of a frame."""
    # BEGIN SOLUTION
    prefix, name = prefix.strip("/"), name.strip("/")
    return f"{prefix}/{name}" if prefix and name != "map" else name
    # END SOLUTION


# %% name="e4-7-check" tags=["check"]
check("E4.7", frame_name)

# %% [markdown] lang="en" name="done"
# ## What you have shown
#
# You can read a tree, fix it, and name the cause. In a class, grading asks the same questions about other robots.
#
# **Next:** [05 · map, odom, base_link](../../notebooks/en/05_map_odom_base_link.ipynb).

# %% [markdown] lang="ko" name="done"
# ## 여기까지 해낸 것
#
# 트리를 읽고, 고치고, 어느 노드가 원인인지 말할 수 있습니다. 채점할 때는 같은 문제를 다른 로봇으로 확인합니다.
# **다음:** [05 · map, odom, base_link](../../notebooks/ko/05_map_odom_base_link.ipynb).
