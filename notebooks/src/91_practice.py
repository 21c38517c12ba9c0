# %% [markdown] lang="en" name="title" slide="slide"
# # Practice without end
#
# The course's tasks again; where a task has numbers, each time with others.
# What went wrong comes back soon; what goes right comes back later and later.
# Nothing here counts: no marks, no ticks, and nobody sees it but you.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 끝없는 연습
#
# 각 장의 과제를 다시 풉니다. 숫자가 있는 과제는 매번 숫자가 다릅니다.
# 틀린 것은 금방 다시 나오고, 맞힌 것은 점점 더 뒤에 나옵니다.
# 여기서 푼 것은 점수에도 학습 현황에도 들어가지 않으며, 본인 말고는 아무도 보지 못합니다.

# %% name="load"
# %load_ext tflab
from tflab.workbook import practice

# %% [markdown] lang="en" name="where" slide="skip"
# ## Where do you stand?
#
# What was shown, when, and what comes next. It is kept in your copy, in `practice.json`.

# %% [markdown] lang="ko" name="where" slide="skip"
# ## 지금 어디까지 왔을까요?
#
# 지금까지 무엇을 틀렸는지, 언제였는지, 다음에는 무엇이 나오는지 보여 줍니다. 기록은 내 워크북의 `practice.json`에 있습니다.

# %% name="standing" tags=["translated"]
practice.standing()

# %% [markdown] lang="en" name="how" slide="skip"
# ## Ask
#
# Run the next cell: a question appears, and below it a cell for your answer.
# Fill in the blanks and run that cell; the reply is the one that `check` gives in an exercise.
# After a pass, run `practice.ask()` again. `practice.ask(3, 8)` asks about chapters 3 and 8; else it goes as far as you have come.
#
# Stop whenever you like: the question waits. In a terminal, `tflab practice` does the same.

# %% [markdown] lang="ko" name="how" slide="skip"
# ## 문제 받기
#
# 다음 셀을 실행하면 문제가 나오고, 그 아래에 답을 쓸 셀이 생깁니다.
# 빈자리를 채우고 그 셀을 실행해 보세요. 연습 문제에서 `check`가 하는 것과 똑같이 답합니다.
# 맞힌 다음에는 `practice.ask()`를 다시 실행합니다. `practice.ask(3, 8)`은 3장과 8장에서만 내고, 그냥 실행하면 지금까지 공부한 장에서 냅니다.
#
# 언제 멈추어도 됩니다. 풀던 문제가 그대로 기다립니다. 터미널에서 `tflab practice`를 실행해도 똑같습니다.

# %% name="ask" tags=["interactive"]
practice.ask()

# %% [markdown] lang="en" name="boxes" slide="skip"
# ## When does it come again?
#
# Each idea of the course lies in one of five boxes: a misconception such as *the inverse is only a minus sign*, or a task that looks for none.
#
# | box | comes again after | or after |
# |--:|:--|:--|
# | 1 | 1 other task | an hour |
# | 2 | 4 other tasks | a day |
# | 3 | 12 | 3 days |
# | 4 | 36 | a week |
# | 5 | 108 | 3 weeks |
#
# Right when it was due: one box up. Right after a hint: it stays. Wrong, or its misconception shown, here or in an exercise: back to box 1.
# This is called *spaced repetition*; the boxes are Sebastian Leitner's (1972).

# %% [markdown] lang="ko" name="boxes" slide="skip"
# ## 언제 다시 나올까요?
#
# 상자는 다섯 개이고, 연습할 것은 저마다 그 가운데 하나에 들어 있습니다. 잘못 알기 쉬운 점 하나(예: *역변환은 부호만 바꾸면 된다*)가 연습할 것 하나입니다. 그런 점을 다루지 않는 과제는 과제 하나가 연습할 것 하나입니다.
#
# | 상자 | 다시 나오는 때 | 또는 |
# |--:|:--|:--|
# | 1 | 다른 과제 1개 뒤 | 한 시간 뒤 |
# | 2 | 다른 과제 4개 뒤 | 하루 뒤 |
# | 3 | 12개 뒤 | 사흘 뒤 |
# | 4 | 36개 뒤 | 일주일 뒤 |
# | 5 | 108개 뒤 | 3주 뒤 |
#
# 때가 되어 나온 것을 맞히면 다음 상자로 올라갑니다. 힌트를 보고 맞히면 그대로 있습니다. 틀리거나, 여기서든 연습 문제에서든 잘못 아는 점이 드러나면 1번 상자로 돌아갑니다.
# 이런 방법을 *간격 반복(spaced repetition)*이라고 하며, 상자는 제바스티안 라이트너(Sebastian Leitner, 1972)가 생각해 냈습니다.
#
# *그림 읽기:* task = 과제, h = 시간, d = 일.

# %% name="boxes-drawn"
practice.boxes()
