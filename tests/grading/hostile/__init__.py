"""A library of what people hand in: hostile, broken, and odd but right.

    recipe       what a recipe is, and what they are made of
    forging      points claimed                    tampering  another notebook than was handed out
    peeking      what was asked, or expected       files      no notebook, an old one, another encoding
    exhaustion   time and memory                   helpers    honest cells of one's own
    survival     what is left for others           odd        right, oddly written
    guessing     no understanding, two answers, any size, mistakes in one branch
    counting     by the number of the call, the kernel, the clock, the machine
    objects      objects that are not what they say
    shell        the kernel, what it shows and imports; what stands in the notebook around the cells
    stealing     others' work, the pack, ways out
    harm         what takes from others
    late         what comes behind the answer
    settings     what is set for the whole process
    unseen       what no look at memory, files and processes sees
    made         objects, patches and outcomes by the dozen
    habits       what honest people do besides answering
    hedges       one answer or none by the moment, names that only look right, an engine that agrees
    clinic       patients named without being examined; these are for chapter 12

Code that stands in an answer or in a cell of its own is in `<name>.yaml`; what edits a notebook is in `<name>.py`.
Each entry is a recipe: an honest notebook, of chapter 03 but for the clinic, goes in, what is handed in
comes out.  `spoils` names the task whose answer the recipe replaces by an attack
("function", "value", or "" for none): it must get nothing; a "mistake" may get a part.  `keeps` says which
honest points have to survive: "all" of them, the "others" (all but the spoilt
task's), or "none" where there is nothing left to read.
"""

from .clinic import CLINIC
from .counting import COUNTING
from .exhaustion import EXHAUSTION
from .files import FILES
from .guessing import GUESSING, SLIPS
from .helpers import HELPERS
from .made import MADE
from .recipe import Honest, Recipe, honest_notebook, recipes
from .shell import NOTEBOOKS
from .tampering import TAMPERING

__all__ = ["CLINIC", "KINDS", "Honest", "Recipe", "honest_notebook"]

PAGES = ("forging", "peeking", "survival", "odd", "objects", "shell", "stealing", "harm", "late", "settings", "unseen",
         "habits", "hedges")  # fmt: skip
KINDS = [
    *map(recipes, PAGES), EXHAUSTION, TAMPERING, FILES, HELPERS, GUESSING, SLIPS, COUNTING, NOTEBOOKS, MADE,
]  # fmt: skip
