# %% [markdown] lang="en" name="title"
# # Exercise 00 · Fifteen questions, before you know anything
#
# One task, about 15 minutes. The page it belongs to: [Start here](../../notebooks/en/00_start.ipynb).
#
# These are fifteen questions about robots, in everyday words.
# You answer similar questions again at the end of the last chapter, with other numbers.
# Nothing here is marked. A wrong answer is useful, and you may guess if you mark the answer as a guess. In a class, you get the point for answering.
#
# Neither `check` nor your copy shows the right answers until you have answered the second form, E12.8. Then you see both forms, an explanation of each option, what you have learned, and what to read again.
# (tflab is public, so you can find the right answers in its files. But then the comparison of before and after means nothing.)

# %% [markdown] lang="ko" name="title"
# # 연습 문제 00 · 배우기 전에 풀어 보는 열다섯 문제
#
# 과제 하나, 약 15분입니다. 함께 보는 페이지: [여기서 시작합니다](../../notebooks/ko/00_start.ipynb).
#
# 로봇에 관한 열다섯 문제를 일상의 말로 묻습니다.
# 마지막 장이 끝나면 숫자만 바뀐 같은 문제를 다시 만납니다.
# 채점하지 않습니다. 틀린 답도 쓸모가 있고, 짐작해도 됩니다. 짐작한 답에는 짐작이라고 표시해 보세요. 수업에서는 맞았는지가 아니라 답했는지에 점수를 줍니다.
#
# 두 번째 시험지인 E12.8에 답할 때까지는 `check`도, 내 워크북의 어떤 파일도 정답을 알려 주지 않습니다. 그때 시험지 두 장의 정답이 함께 공개됩니다. 보기마다 설명이 한 문장씩 나오고, 무엇을 배웠고 무엇을 다시 보면 좋을지도 나옵니다.
# (tflab은 공개되어 있으므로 마음먹으면 정답을 찾아낼 수 있습니다. 그러면 자신의 처음과 끝을 비교할 수 없게 될 뿐입니다.)

# %% name="load"
# %load_ext tflab
from tflab.workbook import check, task

# %% [markdown] lang="en" name="e0-1"
# ## E0.1 · Fifteen questions, before (1 point)
#
# You have fifteen questions and fifteen minutes. Answer without looking anything up. If you do not know an answer, go on to the next question.
# Write one letter for each into the cell below the last question, from `"a"` to `"d"`.
# A `?` after the letter means *I guessed*: `"c?"`. If you do not know, write `"e"`.

# %% [markdown] lang="ko" name="e0-1"
# ## E0.1 · 열다섯 문제, 처음 (1점)
#
# 열다섯 문제에 15분입니다. 아무것도 찾아보지 말고 풀고, 모르면 다음 문제로 넘어가십시오.
# 마지막 문제 아래의 셀에 문제마다 `"a"`에서 `"d"`까지 글자 하나를 쓰십시오.
# 글자 뒤의 `?`는 *짐작*이라는 뜻입니다. 예: `"c?"`. 모르면 `"e"`를 쓰십시오.

# %% [markdown] lang="en" name="questions"
# Unless a question says otherwise, *x* is ahead, *y* is to the left, *z* is up, and lengths are in metres. (2, 0) is two metres ahead.

# %% [markdown] lang="ko" name="questions"
# 따로 말하지 않으면 *x*는 앞쪽, *y*는 왼쪽, *z*는 위쪽이고, 길이의 단위는 미터입니다. (2, 0)은 2미터 앞입니다.

# %% [markdown] lang="en" name="question-1"
# **1.** A laser is fixed to a robot, 0.2 ahead of the robot's centre and turned 90° to the left. It reports a ball at (2, 0), straight ahead of itself. Where is the ball for the robot?
#
# - **a** (2.2, 0)
# - **b** (0.2, 2.0)
# - **c** (0, −1.8)
# - **d** (0, 2.2)
# - **e** I do not know

# %% [markdown] lang="ko" name="question-1"
# **1.** 로봇 한가운데에서 앞으로 0.2 떨어진 자리에 레이저가 왼쪽으로 90° 회전한 채 고정되어 있습니다. 레이저는 자기 정면 (2, 0)에 공이 있다고 알립니다. 로봇을 기준으로 공은 어디에 있습니까?
#
# - **a** (2.2, 0)
# - **b** (0.2, 2.0)
# - **c** (0, −1.8)
# - **d** (0, 2.2)
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-2"
# **2.** In a drawing, an arrow goes from a robot to its camera. The numbers (0.10, 0, 0.30) are written beside it. The camera sees a mark exactly at the camera's own origin. What do you know then?
#
# - **a** For the robot, the mark is at (0.10, 0, 0.30).
# - **b** Numbers can be taken from robot to camera only, not back.
# - **c** For the robot, the mark is at (−0.10, 0, −0.30).
# - **d** It shows who sends messages to whom, and nothing about positions.
# - **e** I do not know

# %% [markdown] lang="ko" name="question-2"
# **2.** 그림에 로봇에서 카메라로 향하는 화살표가 있고, 그 옆에 (0.10, 0, 0.30)이라고 적혀 있습니다. 카메라에 보이는 표식 하나가 정확히 카메라의 원점에 있습니다. 이로부터 알 수 있는 것은 무엇입니까?
#
# - **a** 로봇을 기준으로 표식은 (0.10, 0, 0.30)에 있습니다.
# - **b** 값은 로봇 기준에서 카메라 기준으로만 바꿀 수 있고, 거꾸로는 바꿀 수 없습니다.
# - **c** 로봇을 기준으로 표식은 (−0.10, 0, −0.30)에 있습니다.
# - **d** 누가 누구에게 메시지를 보내는지를 나타낼 뿐, 위치와는 상관없습니다.
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-3"
# **3.** Seen from A, B is at (2, 0) and turned 90° to the left. Where is A, seen from B?
#
# - **a** (−2, 0)
# - **b** (2, 0)
# - **c** (0, −2)
# - **d** (0, 2)
# - **e** I do not know

# %% [markdown] lang="ko" name="question-3"
# **3.** A를 기준으로 B는 (2, 0)에 있고 왼쪽으로 90° 회전해 있습니다. B를 기준으로 A는 어디에 있습니까?
#
# - **a** (−2, 0)
# - **b** (2, 0)
# - **c** (0, −2)
# - **d** (0, 2)
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-4"
# **4.** A camera's software counts x to the right, y down, z ahead. A cup stands 2 ahead of it and 0.5 to the left, at the same height. What does it write?
#
# - **a** (2, 0.5, 0)
# - **b** (0.5, 0, 2)
# - **c** (−0.5, 0, 2)
# - **d** (0, −2, −0.5)
# - **e** I do not know

# %% [markdown] lang="ko" name="question-4"
# **4.** 어떤 카메라 소프트웨어에서는 x가 오른쪽, y가 아래쪽, z가 앞쪽을 향합니다. 컵이 카메라에서 앞으로 2, 왼쪽으로 0.5 떨어진 곳에 카메라와 같은 높이로 놓여 있습니다. 이 소프트웨어는 컵의 위치를 어떻게 적습니까?
#
# - **a** (2, 0.5, 0)
# - **b** (0.5, 0, 2)
# - **c** (−0.5, 0, 2)
# - **d** (0, −2, −0.5)
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-5"
# **5.** The rotation of a part is sent as four numbers. “No rotation” is (0, 0, 0, 1). A program sends (0, 0, 0, 0). What happens?
#
# - **a** It is taken as “no rotation”.
# - **b** The sender stops with an error.
# - **c** Every receiver rejects it, and for the receivers the part does not exist.
# - **d** The last valid rotation stays.
# - **e** I do not know

# %% [markdown] lang="ko" name="question-5"
# **5.** 부품의 회전은 숫자 네 개로 보내며, ‘회전 없음’은 (0, 0, 0, 1)입니다. 어떤 프로그램이 (0, 0, 0, 0)을 보냅니다. 무슨 일이 일어납니까?
#
# - **a** ‘회전 없음’으로 받아들입니다.
# - **b** 보내는 쪽이 오류를 내고 멈춥니다.
# - **c** 받는 쪽마다 거절하며, 받는 쪽에는 그 부품이 없습니다.
# - **d** 마지막으로 받은 올바른 회전이 그대로 쓰입니다.
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-6"
# **6.** Two programs each report the robot's position 20 times a second: one “1.0”, the other “1.4”. You ask for the position at times between the messages. What do you get?
#
# - **a** 1.0, from the program that was first
# - **b** always 1.2
# - **c** an error that names both
# - **d** 1.0, 1.4 and anything between, changing
# - **e** I do not know

# %% [markdown] lang="ko" name="question-6"
# **6.** 두 프로그램이 저마다 1초에 20번씩 로봇의 위치를 알립니다. 하나는 “1.0에 있다”, 다른 하나는 “1.4에 있다”라고 합니다. 메시지와 메시지 사이 시각의 위치를 요청하면 무엇을 얻습니까?
#
# - **a** 먼저 알린 1.0
# - **b** 언제나 1.2
# - **c** 두 프로그램의 이름이 나오는 오류
# - **d** 때에 따라 이 값이나 저 값, 또는 아무도 알리지 않은 그 사이의 값
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-7"
# **7.** A robot's wheels have counted 10.0 from the door. A map shows it 9.4 from the door. The wheel program keeps reporting “10.0 in my count”. What should the map program announce?
#
# - **a** “The robot is at 9.4 on the map.”
# - **b** “Zero of that count is at −0.6 on the map.”
# - **c** “Set your count to 9.4.”
# - **d** “Zero of that count is at +0.6 on the map.”
# - **e** I do not know

# %% [markdown] lang="ko" name="question-7"
# **7.** 로봇이 바퀴로 센 거리는 문에서부터 10.0입니다. 지도에서는 로봇이 문에서 9.4 떨어져 있습니다. 바퀴 프로그램은 계속해서 “내가 센 값으로 10.0”이라고 알립니다. 지도 프로그램은 무엇을 알려야 합니까?
#
# - **a** “로봇은 지도에서 9.4에 있다.”
# - **b** “바퀴로 세기 시작한 0은 지도에서 −0.6에 있다.”
# - **c** “센 값을 9.4로 고쳐라.”
# - **d** “바퀴로 세기 시작한 0은 지도에서 +0.6에 있다.”
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-8"
# **8.** Two programs report where a robot is. S never jumps, but is 0.5 m off after ten minutes. J is right to 2 cm, but jumps 5 cm now and then. Which one do you use to steer smoothly along the next two metres?
#
# - **a** S
# - **b** J, because it is right
# - **c** whichever is newer
# - **d** neither: a program that drifts is broken
# - **e** I do not know

# %% [markdown] lang="ko" name="question-8"
# **8.** 로봇의 위치를 알려 주는 출처가 둘 있습니다. S는 튀지 않지만 10분 뒤에는 0.5 m 어긋납니다. J는 오차가 2 cm를 넘지 않지만 가끔 5 cm씩 튑니다. 앞으로 2 m를 끊김 없이 조향하는 데는 어느 것을 씁니까?
#
# - **a** S
# - **b** 정확한 J
# - **c** 더 최근의 것
# - **d** 둘 다 쓰지 않음: 조금씩 어긋나면 고장입니다
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-9"
# **9.** A robot drives 1 m/s and turns 0.5 rad/s. A picture that is 0.2 s old shows a post 5 ahead. The post is drawn on the map from the robot's current position and direction. By about how much is the post off?
#
# - **a** 0: posts stand still
# - **b** 0.20
# - **c** 0.54
# - **d** 0.10
# - **e** I do not know

# %% [markdown] lang="ko" name="question-9"
# **9.** 로봇이 1 m/s로 달리면서 0.5 rad/s로 회전하고 있습니다. 0.2초 전에 찍은 영상에는 기둥이 앞쪽 5에 있습니다. 이 기둥을 로봇의 지금 위치와 방향으로 지도에 표시합니다. 기둥은 얼마쯤 빗나갑니까?
#
# - **a** 0: 기둥은 움직이지 않습니다
# - **b** 0.20
# - **c** 0.54
# - **d** 0.10
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-10"
# **10.** For an hour, the time in each message has been 0.4 s later than the time at which you receive it, to the millisecond. What do you do?
#
# - **a** wait up to 1 s for what is missing
# - **b** use the newest data instead
# - **c** write the time of arrival into each
# - **d** set that computer's clock
# - **e** I do not know

# %% [markdown] lang="ko" name="question-10"
# **10.** 한 시간째 모든 메시지에 적힌 시각이 그 메시지를 받은 순간보다 0.4초 나중입니다. 밀리초까지 언제나 똑같습니다. 어떻게 합니까?
#
# - **a** 빠진 것을 1초까지 기다립니다
# - **b** 대신 가장 최근의 데이터를 씁니다
# - **c** 메시지마다 도착한 시각을 써넣습니다
# - **d** 그 컴퓨터의 시계를 맞춥니다
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-11"
# **11.** A guide refuses in three ways: “I do not know this name” · “I know both places, but no road joins them” · “There is a road, but I know nothing about it for that hour”. After the second, what do you look for?
#
# - **a** a spelling
# - **b** the missing stretch
# - **c** a longer wait
# - **d** a restart: all three mean that it is broken
# - **e** I do not know

# %% [markdown] lang="ko" name="question-11"
# **11.** 안내원은 세 가지로 거절합니다. “그런 이름은 모릅니다” · “두 곳 다 알지만 잇는 길이 없습니다” · “길은 있지만 그 시각의 상황은 모릅니다”. 두 번째 말을 들었다면 무엇을 살펴봅니까?
#
# - **a** 철자
# - **b** 빠진 구간
# - **c** 얼마나 더 기다릴지
# - **d** 다시 켜기: 셋 다 고장이라는 뜻입니다
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-12"
# **12.** A program reports once, at 9:00, where a laser is fixed. Another program starts at 9:05. Why should it get this report?
#
# - **a** The last report is kept for programs that start later, as long as its sender runs.
# - **b** It is repeated 20 times a second.
# - **c** The network stores everything that was ever sent.
# - **d** It cannot: 9:00 is too old.
# - **e** I do not know

# %% [markdown] lang="ko" name="question-12"
# **12.** “레이저는 여기에 고정되어 있다”를 9시에 한 번 알립니다. 받는 프로그램은 9시 5분에 켜집니다. 그래도 되는 까닭은 무엇입니까?
#
# - **a** 보낸 프로그램이 실행되는 동안 마지막 알림이 나중에 온 쪽을 위해 남아 있습니다.
# - **b** 1초에 20번씩 되풀이됩니다.
# - **c** 네트워크가 오간 것을 모두 저장합니다.
# - **d** 되지 않습니다. 9시는 너무 오래되었습니다.
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-13"
# **13.** You have recorded what the laser of a robot measured, and nothing else. Next week you want to make a map of it. What is missing?
#
# - **a** nothing: the measurements contain the walls
# - **b** only a faster computer
# - **c** where the robot was, where the laser is fixed, and which clock is used
# - **d** the robot, switched on beside you: its present position is enough
# - **e** I do not know

# %% [markdown] lang="ko" name="question-13"
# **13.** 로봇의 레이저가 잰 것만 기록하고 다른 것은 기록하지 않았습니다. 다음 주에 이것으로 지도를 만들려고 합니다. 무엇이 빠졌습니까?
#
# - **a** 빠진 것이 없습니다. 잰 값에 벽이 들어 있습니다
# - **b** 더 빠른 컴퓨터만 있으면 됩니다
# - **c** 로봇의 위치, 레이저가 달린 자리, 그리고 어느 시계를 따르는지
# - **d** 옆에 켜 둔 로봇: 지금 위치만 알면 됩니다
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-14"
# **14.** Two robots write on one board. Their programs are grouped as r1/… and r2/…, but both announce “base is at …”. What do readers find?
#
# - **a** The group's name is put in front of it.
# - **b** The second is refused.
# - **c** Two robots, told apart by the sender.
# - **d** There is one base, and it jumps.
# - **e** I do not know

# %% [markdown] lang="ko" name="question-14"
# **14.** 로봇 두 대가 알림판 하나를 함께 씁니다. 프로그램은 r1/…과 r2/…으로 묶여 있지만, 둘 다 “base는 …에 있다”라고 알립니다. 읽는 쪽은 무엇을 보게 됩니까?
#
# - **a** 그룹 이름이 앞에 붙습니다.
# - **b** 두 번째 로봇의 알림은 거절됩니다.
# - **c** 보낸 쪽으로 구별되는 로봇 두 대를 봅니다.
# - **d** base는 하나이고, 이리저리 튑니다.
# - **e** 모르겠습니다

# %% [markdown] lang="en" name="question-15"
# **15.** A viewer shows no laser points. It says “No transform to fixed frame [map]”, and its counter says 10 scans a second. What do you do first?
#
# - **a** check the sensor and its cable
# - **b** let it wait longer
# - **c** restart the viewer
# - **d** find out which step between laser and map is missing
# - **e** I do not know

# %% [markdown] lang="ko" name="question-15"
# **15.** 시각화 프로그램에 레이저 점이 나타나지 않습니다. “No transform to fixed frame [map]”이라고 쓰여 있고, 카운터에는 스캔이 1초에 10개 온다고 나옵니다. 맨 먼저 무엇을 합니까?
#
# - **a** 센서와 케이블을 확인합니다
# - **b** 더 오래 기다리게 합니다
# - **c** 시각화 프로그램을 다시 켭니다
# - **d** 레이저와 map 사이에서 어느 구간이 빠졌는지 찾습니다
# - **e** 모르겠습니다


# %% name="e0-1-answer" tags=["answer"]
before = {
    # BEGIN SOLUTION
    "1": "e", "2": "e", "3": "e", "4": "e", "5": "e",
    "6": "e", "7": "e", "8": "e", "9": "e", "10": "e",
    "11": "e", "12": "e", "13": "e", "14": "e", "15": "e",
    # END SOLUTION
}

# %% name="e0-1-check" tags=["check"]
check("E0.1", before)

# %% [markdown] lang="en" name="after"
# Whatever you wrote: go on to [chapter 01](../../notebooks/en/01_value_frame_stamp.ipynb), and do not look back. The first complete answer is the one that is kept.

# %% [markdown] lang="ko" name="after"
# 무엇을 썼든 [01장](../../notebooks/ko/01_value_frame_stamp.ipynb)으로 가십시오. 처음으로 끝까지 쓴 답이 보관됩니다.
