"""Practice: what went wrong comes again soon, what went right ever later, and nothing that was done is lost."""

from __future__ import annotations

import builtins
import json
import random
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest

from tflab.workbook import practice, progress, trying
from tflab.workbook.answers.forms import Choice, Number, Sequence
from tflab.workbook.places import workbook_data
from tflab.workbook.practice import cells, command, deck, kept, sentences, session, spacing
from tflab.workbook.practice.prompt import Mistyped, value_of
from tflab.workbook.practice.session import Session
from tflab.workbook.practice.spacing import GAPS, Idea, Pick, after, choose, is_due
from tflab.workbook.practice.terminal import as_text
from tflab.workbook.tasks.reference import in_process_ros, solution_in_notebook
from tflab.workbook.tasks.task import read_tasks

from . import small_chapter
from .conftest import notebook
from .each_task import READS, each_task, task_in

DAY_S = 86400
START_S = 1_800_000_000
STEMS = sorted(path.name for path in (workbook_data() / "solutions" / "tasks").glob("[0-9]*"))
COURSE = deck.items(STEMS)
TASKS = {name: item.ideas for name, item in COURSE.items()}
OUR_WORKBOOK = workbook_data()


# -- the rule -----------------------------------------------------------------------


@pytest.mark.parametrize(("box", "gap"), list(enumerate(GAPS, start=1)))
def test_an_idea_comes_back_after_so_many_tasks_or_so_long_and_not_before(box: int, gap: spacing.Spacing) -> None:
    idea = Idea(box=box, number=10, asked_s=START_S)
    assert not is_due(idea, 10 + gap.tasks, START_S + gap.seconds - 1)
    assert is_due(idea, 10 + gap.tasks + 1, START_S)
    assert is_due(idea, 11, START_S + gap.seconds)


def test_each_box_stays_away_longer_than_the_one_before() -> None:
    assert all(near.tasks < far.tasks and near.seconds < far.seconds for near, far in pairwise(GAPS))


@pytest.mark.parametrize(
    ("before", "right", "hinted", "shown", "wanted"),
    [
        (Idea(box=2, shown=1, number=1), True, False, (), (3, 1, 1)),
        (Idea(box=5, shown=1, right=9, number=1), True, False, (), (5, 1, 10)),
        (Idea(box=2, shown=1, number=1), True, True, (), (2, 1, 0)),
        (Idea(box=4, shown=1, right=3, number=1), False, False, (), (1, 1, 0)),
        (Idea(box=4, shown=1, right=3, number=1), False, False, ("M3",), (1, 2, 0)),
        (Idea(box=2, shown=1, number=99), True, False, (), (2, 1, 1)),  # not due yet: no box is earned
        (None, True, False, (), (2, 0, 1)),
        (None, True, True, (), (1, 0, 1)),
        (None, False, False, (), (1, 0, 0)),
    ],
)
def test_right_goes_a_box_up_and_wrong_back_to_the_first(before, right, hinted, shown, wanted) -> None:
    ideas = {} if before is None else {"M3": before}
    moved = after(
        ideas, ("M3",), Pick("E3.2", "M3", "due"), number=100, now_s=5, right=right, hinted=hinted,
        shown=frozenset(shown),
    )["M3"]  # fmt: skip
    assert (moved.box, moved.shown, moved.right) == wanted
    assert (moved.number, moved.asked_s) == (100, 5)


def test_a_pass_says_something_of_every_idea_that_is_due_and_nothing_of_one_that_is_not() -> None:
    ideas = {"M1": Idea(box=2, number=1), "M5": Idea(box=4, number=98)}
    moved = after(ideas, ("M3", "M1", "M5"), Pick("E3.4", "M3", "new"), number=100, now_s=0, right=True)
    assert {name: idea.box for name, idea in moved.items()} == {"M3": 2, "M1": 3, "M5": 4}


class Learner:
    """Answers the course's questions, two minutes each: wrongly, showing a misconception, for as long as told."""

    def __init__(self, seed: int = 1) -> None:
        self.ideas: dict[str, Idea] = {}
        self.asked: dict[str, int] = {}
        self.number, self.now_s = 1, START_S
        self.dice = random.Random(seed)

    def is_asked(self) -> Pick:
        pick = choose(TASKS, self.ideas, self.asked, self.number, self.now_s)
        self.asked[pick.task] = self.number
        return pick

    def answers(self, pick: Pick, shown: frozenset[str] = frozenset()) -> None:
        self.ideas = after(
            self.ideas, TASKS[pick.task], pick, number=self.number, now_s=self.now_s, right=not shown, shown=shown
        )
        self.number, self.now_s = self.number + 1, self.now_s + 120

    def practises(self, count: int, misconception: str = "") -> list[Pick]:
        picks = []
        for _ in range(count):
            picks.append(self.is_asked())
            shown = {misconception} & set(TASKS[picks[-1].task])
            self.answers(picks[-1], frozenset(shown))
        return picks


@pytest.mark.parametrize("misconception", [f"M{number}" for number in range(1, 16)])
@pytest.mark.parametrize("seed", range(4))
def test_who_shows_a_misconception_twice_meets_it_within_three_tasks_and_less_after_three_right(
    misconception: str, seed: int
) -> None:
    learner = Learner(seed)
    learner.number += 1000 * seed  # another draw
    while learner.ideas.get(misconception, Idea()).shown < 2:
        learner.practises(1, misconception)
    assert any(misconception in TASKS[pick.task] for pick in learner.practises(3, misconception))
    believing = sum(pick.idea == misconception for pick in learner.practises(60, misconception))
    while learner.ideas[misconception].right < 3:
        learner.practises(1)
    cured = sum(pick.idea == misconception for pick in learner.practises(60))
    assert believing >= 20
    assert cured < believing / 2


def test_a_thousand_questions_never_ask_one_task_twice_in_a_row_and_all_of_them_in_the_end() -> None:
    learner = Learner()
    picks = []
    for _ in range(1000):
        pick = learner.is_asked()
        wrong = learner.dice.random() < 0.3
        learner.answers(pick, frozenset([learner.dice.choice(TASKS[pick.task])]) if wrong else frozenset())
        picks.append(pick.task)
    assert all(one != other for one, other in pairwise(picks))
    assert set(picks) == set(TASKS)


@pytest.mark.proof(reads=READS)
@each_task
def test_what_is_drawn_has_a_right_answer_and_it_is_the_solutions(stem: str, file: str) -> None:
    task = task_in(stem, file).id
    if task not in COURSE:
        return  # it is never asked: see the test below
    item = COURSE[task]
    number = 1000 + list(COURSE).index(task)
    question = practice_question(item, number)
    solution = solution_in_notebook(OUR_WORKBOOK / "solutions" / "en" / f"{item.stem}.ipynb")
    with in_process_ros():
        answer = solution.answer(item.task, question.given if question.variant.given is not None else None)
        verdict, _ = trying.tried_on(Session(OUR_WORKBOOK).assigned(question), answer)
    assert verdict.mistake is None
    assert f"{task} · " in question.text.splitlines()[0]
    assert " points)" not in question.text.splitlines()[0]
    assert item.task.answer in question.starter
    assert "task(" not in question.starter


def practice_question(item: deck.Askable, number: int):
    from tflab.workbook.practice.question import question_of

    return question_of(kept.Open(number, item.task.id, item.ideas[0], "new"), item, "en")


def test_neither_the_test_nor_what_takes_minutes_to_draw_is_asked() -> None:
    tasks = {task.id for stem in STEMS for task in read_tasks(OUR_WORKBOOK / "solutions" / "tasks" / stem)}
    assert tasks - set(TASKS) == {"E0.1", "E12.2", "E12.4", "E12.7", "E12.8"}


def test_the_same_number_draws_the_same_and_another_number_something_else() -> None:
    one, same, other = (deck.drawn("03_target_and_source", "E3.2", number) for number in (7, 7, 8))
    assert one.variants[0].given == same.variants[0].given != other.variants[0].given


# -- a copy --------------------------------------------------------------------------


@pytest.fixture
def copy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A learner's copy of a small chapter, and the workbook that it comes from."""
    data = tmp_path / "workbook"
    root = small_chapter.copy_of_workbook(tmp_path, monkeypatch)
    for language, title in (("en", "Corner"), ("ko", "모서리")):
        folder = data / "exercises" / language
        folder.mkdir(parents=True)
        asked = notebook(
            load="%load_ext tflab\nfrom tflab.workbook import check, task", imports="import math",
            e3_1=f"## E3.1 · {title} (3 points)\n\nWhere is it in `base_link`?", e3_1_given='e3_1 = task("E3.1")',
            e3_1_answer="base_p_corner = ...", e3_2_answer='def invert(T):\n    raise NotImplementedError("your turn")',
        )  # fmt: skip
        (folder / f"E{small_chapter.STEM}.ipynb").write_text(asked, encoding="utf-8")
    monkeypatch.chdir(root)
    monkeypatch.setattr(session, "_now_s", lambda: START_S)
    cells._shown.clear()
    yield root
    cells._shown.clear()


def right_answer(asked) -> object:
    """Return the answer to a question of the small chapter."""
    if asked.item.task.id == "E3.1":
        given = asked.given
        return given["base_T_laser"].apply(given["laser_p_corner"])
    return {"E3.2": lambda T: T.inverse(), "E3.3": {"target": "map", "source": "laser"}, "E3.4": 1.5708}[
        asked.item.task.id
    ]


def answer_rightly(practising: Session) -> str:
    asked = practising.question()
    assert practising.answer(asked, right_answer(asked)).is_over
    return asked.item.task.id


def test_a_misconception_that_check_named_comes_within_three_questions(copy: Path) -> None:
    for _ in range(2):
        progress.record_try(copy, "E3.2", 0, 4, "minus")
    asked = []
    practising = Session(copy)
    for _ in range(3):
        asked.append(answer_rightly(practising))
    assert "E3.2" in asked
    assert practising.kept.ideas["M3"].shown == 2


def test_one_that_check_names_while_one_practises_goes_back_to_the_first_box(copy: Path) -> None:
    progress.record_try(copy, "E3.2", 0, 4, "minus")
    practising = Session(copy)
    answer_rightly(practising)
    assert practising.kept.ideas["M3"].box == 2
    progress.record_try(copy, "E3.2", 0, 4, "minus")
    asked = practising.question()
    assert (asked.open.idea, practising.kept.ideas["M3"].box, practising.kept.ideas["M3"].shown) == ("M1", 1, 2)


def test_practice_writes_nothing_into_progress(copy: Path) -> None:
    progress.record_try(copy, "E3.2", 0, 4, "minus")
    before = (copy / "progress.json").read_bytes()
    practising = Session(copy)
    asked = practising.question()
    practising.answer(asked, lambda T: T)
    practising.hint(asked)
    answer_rightly(practising)
    practising.leave()
    assert (copy / "progress.json").read_bytes() == before


def test_the_first_answer_decides_and_every_mistake_is_counted(copy: Path) -> None:
    practising = Session(copy)
    asked = practising.question()
    while asked.item.task.id != "E3.3":
        practising.leave()
        asked = practising.question()
    assert not practising.answer(asked, {"target": "laser", "source": "map"}).is_over
    assert practising.answer(asked, {"target": "map", "source": "laser"}).is_over
    assert practising.kept.asked[-1].came == "wrong"
    assert practising.kept.asked[-1].shown == ("M1",)
    assert practising.kept.ideas["M1"] == Idea(box=1, shown=1, number=asked.open.number, asked_s=START_S)


@pytest.mark.parametrize(
    "answer", [..., {"target": "map", "source": ...}, "map", {"target": "nowhere", "source": "map"}]
)
def test_what_is_no_answer_yet_costs_nothing(copy: Path, answer: object) -> None:
    practising = Session(copy)
    while (asked := practising.question()).item.task.id != "E3.3":
        practising.leave()
    assert not practising.answer(asked, answer).is_over
    assert practising.kept.open == asked.open


def test_skipping_puts_a_question_off_and_leaves_the_boxes_alone(copy: Path) -> None:
    progress.record_try(copy, "E3.2", 0, 4, "minus")
    practising = Session(copy)
    assert practising.question().item.task.id == "E3.2"
    practising.leave()
    assert practising.question().item.task.id != "E3.2"
    assert practising.kept.ideas["M3"].box == 1
    assert practising.kept.asked[-1].came == "skipped"


def test_a_file_that_cannot_be_read_is_kept_aside_and_said(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for number, text in enumerate(["", "[]", '{"format": 9}', '{"format": 1, "ideas": {"M3": {"box": 7}}}'], start=1):
        (copy / "practice.json").write_text(text)
        answer_rightly(Session(copy))
        assert (copy / f"practice.kept-{number}.json").read_text() == text
        assert f"It is kept as practice.kept-{number}.json" in capsys.readouterr().err


def test_only_chapters_that_were_reached_are_asked_about_unless_others_are_named(tmp_path: Path) -> None:
    (tmp_path / "workbook.json").write_text(
        json.dumps({"tflab": "0.1.0", "edition": "self-study", "language": "en", "learner": None})
    )
    assert [stem[:2] for stem in Session(tmp_path).stems] == ["01"]
    progress.record_try(tmp_path, "E3.5", 0, 1)
    assert [stem[:2] for stem in Session(tmp_path).stems] == ["01", "02", "03"]
    assert [stem[:2] for stem in Session(tmp_path, ["8", "11"]).stems] == ["08", "11"]


# -- in a terminal -------------------------------------------------------------------


def run(monkeypatch: pytest.MonkeyPatch, *typed: object, words: tuple[str, ...] = ()) -> int:
    """Run `tflab practice`; what is an exception is raised at that prompt, and a function is called first."""
    lines = iter(typed)

    def line(prompt: str = "") -> str:
        print(prompt, end="")
        said = next(lines, EOFError())
        if callable(said):
            said = said()
        if isinstance(said, BaseException):
            raise said
        return str(said)

    monkeypatch.setattr(builtins, "input", line)
    return command.main(list(words))


def first_question(copy: Path, task: str) -> None:
    """Let the open question be this task's."""
    practising = Session(copy)
    while practising.question().item.task.id != task:
        practising.leave()


def test_a_value_is_typed_with_what_is_given(copy: Path, monkeypatch, capsys: pytest.CaptureFixture[str]) -> None:
    first_question(copy, "E3.1")
    assert run(monkeypatch, "e3_1.base_T_laser.apply(e3_1.laser_p_corner)", "quit") == 0
    said = capsys.readouterr().out
    assert "E3.1 · Corner\n\nWhere is it in `base_link`?" in said
    assert "E3.1 ✓ 1/1" in said
    assert "It was about M1 (target and source swapped). Box 2 of 5: it comes again after 4 other tasks" in said
    assert f"Everything is kept ({copy / 'practice.json'}); go on with: tflab practice" in said


def test_what_is_wrong_is_named_and_asked_again_and_enter_keeps_the_rest(
    copy: Path, monkeypatch, capsys: pytest.CaptureFixture[str]
) -> None:
    first_question(copy, "E3.3")
    assert run(monkeypatch, "laser", "1", "1", "2", "quit") == 0
    said = capsys.readouterr().out
    assert "E3.3 ✗ 0/2: turned round" in said
    assert "target (Enter: laser) = " in said
    assert "E3.3 ✓ 2/2" in said


@pytest.mark.parametrize("end", [KeyboardInterrupt(), EOFError()])
def test_ctrl_c_loses_neither_the_question_nor_what_was_typed(
    end: BaseException, copy: Path, monkeypatch, capsys: pytest.CaptureFixture[str]
) -> None:
    first_question(copy, "E3.3")
    number = Session(copy).question().open.number
    assert run(monkeypatch, "map", end) == 0
    assert Session(copy).question().open.number == number
    capsys.readouterr()
    assert run(monkeypatch, "", "laser", "quit") == 0
    said = capsys.readouterr().out
    assert "target (Enter: map) = " in said
    assert "E3.3 ✓ 2/2" in said


def test_a_function_is_written_in_a_file_which_nothing_writes_over(
    copy: Path, monkeypatch, capsys: pytest.CaptureFixture[str]
) -> None:
    first_question(copy, "E3.2")
    file = copy / "practice" / f"{Session(copy).question().open.number:03d}_E3.2.py"
    answered = "def invert(T):\n    return T.inverse()\n"

    def writes(text: str):
        return lambda: file.write_text(text) and ""

    assert run(monkeypatch, "", writes("def invert(T):\n    return 1 / 0 +\n"), KeyboardInterrupt()) == 0
    assert file.read_text().endswith("1 / 0 +\n")
    said = capsys.readouterr().out
    assert "E3.2: not answered yet" in said
    assert "SyntaxError" in said
    assert run(monkeypatch, writes(answered), "quit") == 0
    assert "E3.2 ✓ 8/8" in capsys.readouterr().out or file.read_text() == answered


def test_a_hint_is_read_and_the_idea_stays_in_its_box(copy: Path, monkeypatch, capsys) -> None:
    progress.record_try(copy, "E3.2", 0, 4, "minus")
    first_question(copy, "E3.2")
    file = copy / "practice" / "001_E3.2.py"
    assert run(monkeypatch, "hint", lambda: file.write_text("invert = lambda T: T.inverse()") and "", "quit") == 0
    assert "hint 1 of 3: hint 1" in capsys.readouterr().out
    assert Session(copy).kept.ideas["M3"].box == 1


def test_the_log_says_what_was_shown_when_and_what_comes_next(copy: Path, monkeypatch, capsys) -> None:
    first_question(copy, "E3.3")
    run(monkeypatch, "laser", "map", "skip", "quit")
    capsys.readouterr()
    assert run(monkeypatch, words=("--log",)) == 0
    said = capsys.readouterr().out
    assert "0 right at the first go. None of it counts for marks or progress." in said
    assert "M1 (target and source swapped)\n      box 1; shown 1," in said
    assert "E3.3   M1     wrong at first (M1)" in said


def test_without_a_copy_one_may_practise_and_is_told_that_nothing_is_kept(
    copy: Path, monkeypatch, capsys: pytest.CaptureFixture[str]
) -> None:
    elsewhere = copy.parent / "elsewhere"
    elsewhere.mkdir()
    monkeypatch.chdir(elsewhere)
    assert run(monkeypatch, "quit") == 0
    assert "nothing is kept; make one with: tflab lab" in capsys.readouterr().out
    assert not list(elsewhere.iterdir())


def test_a_chapter_that_is_not_there_is_said(copy: Path, monkeypatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(monkeypatch, words=("--chapters", "14")) == 2
    assert 'there is no chapter "14"; there is 03_small' in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "form", "value"),
    [
        ("2", Choice(("map", "odom")), "odom"),
        ("'map'", Choice(("map", "odom")), "map"),
        ("1, odom", Sequence(Choice(("map", "odom"))), ["map", "odom"]),
        ("['map', 'odom']", Sequence(Choice(("map", "odom"))), ["map", "odom"]),
        ("half * 2", Number("m", 0.1), 1.0),
    ],
)
def test_an_answer_is_typed_as_a_person_would(text: str, form, value) -> None:
    assert value_of(text, form, {"half": 0.5}) == value


def test_what_python_cannot_read_is_said() -> None:
    with pytest.raises(Mistyped, match="NameError: name 'hlaf' is not defined"):
        value_of("hlaf", Number("m", 0.1), {"half": 0.5})


def test_a_question_is_wrapped_at_words_for_a_terminal() -> None:
    text = "## E3.2 · A corner\n\n- **a** one two `three four`\n\n```\nas  it  is\n```\n[page](x.ipynb) 좌표계 기준"
    assert as_text(text, 14) == ("E3.2 · A\ncorner\n\n- a one two\n  `three four`\n\n    as  it  is\npage 좌표계\n기준")


# -- in a notebook -------------------------------------------------------------------


def test_a_notebook_gets_a_cell_for_the_answer_once(copy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    put = []
    monkeypatch.setattr(cells, "_put_below", put.append)
    first_question(copy, "E3.1")
    practice.ask()
    practice.ask()
    assert put == ["import math\n\ne3_1 = practice.given()\nbase_p_corner = ...\n\npractice.check(base_p_corner)"]
    assert practice.given().laser_p_corner == (2.0, 0.5, 0.0)


def test_a_notebook_hears_the_same_replies_and_when_it_comes_again(copy: Path, capsys) -> None:
    first_question(copy, "E3.3")
    practice.check({"target": "laser", "source": "map"})
    assert "E3.3 ✗ 0/2: turned round" in capsys.readouterr().out
    practice.check({"target": "map", "source": "laser"})
    said = capsys.readouterr().out
    assert "E3.3 ✓ 2/2" in said
    assert "Box 1 of 5: it comes again after 1 other task, or in an hour." in said
    practice.check({"target": "map", "source": "laser"})
    assert "practice.ask() brings the next one." in capsys.readouterr().out


def test_a_solution_opens_after_three_tries_and_never_in_a_class(copy: Path, capsys) -> None:
    first_question(copy, "E3.3")
    for ends in (("laser", "map"), ("laser", "map"), ("laser", "laser"), ("map", "map")):  # once more is no new try
        practice.solution()
        assert "the solution opens after a pass or three tries" in capsys.readouterr().out
        practice.check(dict(zip(("target", "source"), ends, strict=True)))
        capsys.readouterr()
    assert kept.read_kept(copy).open.tries == 3
    mark = json.loads((copy / "workbook.json").read_text())
    (copy / "workbook.json").write_text(json.dumps(mark | {"edition": "class", "questions": {"E3.3": "a digest"}}))
    practice.solution()
    assert "in a class, the solutions are with your instructor" in capsys.readouterr().out


def test_every_sentence_is_in_the_language_of_the_copy(copy: Path, monkeypatch, capsys) -> None:
    mark = json.loads((copy / "workbook.json").read_text())
    (copy / "workbook.json").write_text(json.dumps(mark | {"language": "ko"}))
    first_question(copy, "E3.1")
    run(monkeypatch, "e3_1.base_T_laser.apply(e3_1.laser_p_corner)", "quit")
    said = capsys.readouterr().out
    assert "E3.1 · 모서리" in said
    assert "M1 (목표와 원본을 바꿈)에 관한 문제였습니다. 상자 5개 중 2번에 있습니다." in said
    assert "모두 남아 있습니다" in said


def test_a_standing_before_the_first_question_says_so() -> None:
    assert sentences.standing(kept.Kept(), "en", START_S).startswith("Nothing has been practised yet.")


def test_what_an_exercise_has_shown_comes_next_before_any_question_was_asked(copy: Path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(copy)
    progress.record_try(copy, "E3.2", 0, 4, "minus")
    practice.standing()
    assert "What comes next: M3." in capsys.readouterr().out
    assert practice.boxes().text.startswith("box 1 (1 task / 1 h): M3 *")
    assert not (copy / kept.FILE).exists()


def test_a_picture_shows_in_which_box_each_idea_lies_and_which_is_due(copy: Path) -> None:
    progress.record_try(copy, "E3.2", 0, 4, "minus")
    Session(copy).question()
    first, *others = practice.boxes().text.splitlines()
    assert first == "box 1 (1 task / 1 h): M3 *"
    assert others[0] == "box 2 (4 tasks / 1 d): -"
    assert len(others) == 4
