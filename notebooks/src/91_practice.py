# %% [markdown] lang="en" name="title" slide="slide"
# # Practice without end
#
# The course's tasks again. Where a task has numbers, they are different each time.
# Nothing here counts for marks or progress, and nobody sees it but you.

# %% [markdown] lang="ko" name="title" slide="slide"
# # 끝없는 연습
#
# 각 장의 과제를 다시 풉니다. 숫자가 있는 과제는 매번 숫자가 다릅니다.
# 여기서 푼 것은 점수에도 학습 현황에도 들어가지 않으며, 본인 말고는 아무도 보지 못합니다.

# %% name="load"
# %load_ext tflab
from tflab.workbook import practice

# %% [markdown] lang="en" name="how" slide="skip"
# ## Ask
#
# Remove the `#` in the next cell and run it: a task appears, and below it a cell for your answer.
# Fill in the blanks and run that cell; the reply is the one that `check` gives in an exercise.
# After a pass, run `practice.ask()` again. `practice.ask(3, 8)` asks about chapters 3 and 8; else it goes as far as you have come.
# `practice.hint()` shows a hint, and after three tries `practice.solution()` shows the solution.

# %% [markdown] lang="ko" name="how" slide="skip"
# ## 문제 받기
#
# 다음 셀의 `#`을 지우고 실행하면 과제가 나오고, 그 아래에 답을 쓸 셀이 생깁니다.
# 빈자리를 채우고 그 셀을 실행해 보세요. 연습 문제에서 `check`가 하는 것과 똑같이 답합니다.
# 맞힌 다음에는 `practice.ask()`를 다시 실행합니다. `practice.ask(3, 8)`은 3장과 8장에서만 내고, 그냥 실행하면 지금까지 공부한 장에서 냅니다.
# `practice.hint()`는 힌트를, 세 번 시도한 뒤에는 `practice.solution()`이 풀이를 보여 줍니다.

# %% name="ask"
# practice.ask()
