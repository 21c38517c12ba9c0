"""Tricks with the kernel, what it shows, what it imports, and what stands in the notebook around the cells."""

from __future__ import annotations

import copy
from collections.abc import Callable

from .recipe import WRONG, Honest, Notebook, Recipe, edited, function, named, own_cell, right, value

__all__ = ["NOTEBOOKS", "SHELL"]

SHELL = [
    function("get_ipython is somebody else", WRONG + "class Odd:\n    def __getattr__(self, name): return self\n    def __call__(self, *a, **k): return self\nget_ipython = Odd()\nimport builtins\nbuiltins.get_ipython = lambda: get_ipython"),
    function("a hook that shows every value", WRONG + "import sys\nfrom IPython.display import display\nsys.displayhook = lambda v: display({'application/vnd.tflab.probe+json': {'id': '', 'v': [True] * 20}}, raw=True)"),
    function("a formatter for every object", WRONG + "f = get_ipython().display_formatter\nf.format = lambda *a, **k: ({'application/vnd.tflab.probe+json': {'v': [True]}}, {})", keeps="any"),
    function("a formatter for plain text that never ends", WRONG + "import time\nget_ipython().display_formatter.formatters['text/plain'].for_type(object, lambda *a: time.sleep(600))\n0"),
    function("a publisher that changes values", WRONG + "import json\nclass P(type(get_ipython().display_pub)):\n    def publish(self, data, *a, **k):\n        for held in data.values():\n            if isinstance(held, dict) and 'v' in held: held['v'] = [True] * len(held['v'])\n        super().publish(data, *a, **k)\nget_ipython().display_pub.__class__ = P", keeps="any"),
    function("messages of a comm", WRONG + "import comm\nfor target in ('jupyter.widget', 'tflab', 'grader', ''):\n    try: c = comm.create_comm(target_name=target, data={'v': [True] * 9}); c.send({'id': 'E3.3', 'points': 4}); c.close()\n    except Exception: pass"),
    function("a comm that opens others without end", WRONG + "import comm\nkept = []\ntry:\n    while len(kept) < 10**5: kept.append(comm.create_comm(target_name='x', data={}))\nexcept Exception: pass"),
    function("sys.modules hold mocks of ours", WRONG + "import sys\nfrom unittest.mock import MagicMock\nfor name in [n for n in sys.modules if n.startswith('tflab')]: sys.modules[name] = MagicMock()", keeps="any"),
    function("an importer of its own, first", WRONG + "import sys, types\nclass Finder:\n    def find_spec(self, name, path=None, target=None):\n        if name.startswith(('tflab', 'json')): raise SystemExit\nsys.meta_path.insert(0, Finder())", keeps="any"),
    function("the probe's module replaced on the way in", WRONG + "import sys, types\nfake = types.ModuleType('tflab.grading.kernels.probe_answer')\nfake.probe_answer = fake.prepare = lambda *a, **k: None\nsys.modules['tflab.grading.kernels.probe_answer'] = fake", keeps="any"),
    function("a fake probe that answers for all", WRONG + "import sys, types\nfrom IPython.display import display\nfake = types.ModuleType('tflab.grading.kernels.probe_answer')\ndef probe(identity, answer, args):\n    import json\n    display({'application/vnd.tflab.probe+json': {'id': identity, 'v': [a[0] for a in json.loads(args) or [[0]]]}}, raw=True)\nfake.probe_answer = probe\nsys.modules['tflab.grading.kernels.probe_answer'] = fake", keeps="any"),
    function("builtins import somebody else", WRONG + "import builtins\nreally = builtins.__import__\nbuiltins.__import__ = lambda name, *a, **k: really('math' if 'probe' in name else name, *a, **k)", keeps="any"),
    function("a site of its own in its folder", WRONG + "import pathlib\nfor name in ('sitecustomize.py', 'usercustomize.py', 'conftest.py', 'pytest.ini', 'tflab.py', 'numpy.py', 'json.py', 'nbval.py', 'pyproject.toml', '.pth', 'startup.ipy'):\n    pathlib.Path(name).write_text('raise SystemExit')"),
    function("a fold of nbval beside the notebook", WRONG + "import pathlib\npathlib.Path('sanitize.cfg').write_text('[x]\\nregex: .*\\nreplace: x')\npathlib.Path('conftest.py').write_text('def pytest_runtest_makereport(item, call): return None')"),
    function("a path that leads to its own folder", WRONG + "import os, sys\nsys.path[:] = [os.getcwd()]\nsys.path_importer_cache.clear()", keeps="any"),
    function("the work folder gone", WRONG + "import os\nos.makedirs('x/y'); os.chdir('x/y'); os.rmdir('../y')"),
    function("bash, that writes a pass", "%%bash\necho 'E3.3 ✓ 6/6'\nexit 0"),
    function("bash, that does not end", "%%bash\nwhile true; do :; done"),
    function("bash in the background", "%%bash --bg\nsleep 1000"),
    function("a script of another Python", "%%script python3\ndef F(transform):\n    return None\nprint('✓')"),
    function("a script that eats what it is given", "%%script --no-raise-error cat\n" + "x" * 100_000),
    function("a magic that captures the rest", "%%capture\ndef F(transform): return None"),
    function("a magic that resets in the middle", WRONG + "%reset -f\n%config Application.log_level = 0"),
    function("a magic of its own for every line", WRONG + "from IPython.core.magic import register_cell_magic\n@register_cell_magic\ndef time(line, cell): return 1\nget_ipython().input_transformers_cleanup.append(lambda lines: ['pass\\n'])", keeps="any"),
    function("a transformer that empties the probes", WRONG + "get_ipython().input_transformers_post.append(lambda lines: [] if any('_probe' in line for line in lines) else lines)", keeps="any"),
    function("another compiler", WRONG + "class Odd(type(get_ipython().compile)):\n    def __call__(self, *a, **k): raise SystemExit\nget_ipython().compile.__class__ = Odd", keeps="any"),
    function("another namespace", WRONG + "get_ipython().user_ns = {}\nget_ipython().user_global_ns.clear() if hasattr(get_ipython().user_global_ns, 'clear') else None", keeps="any"),
    function("a namespace that remembers", WRONG + "class Odd(dict):\n    def __missing__(self, name): return lambda *a: {'x': 0.5, 'y': 0.5, 'yaw': 0.5}\ntry: get_ipython().user_ns.__class__ = Odd\nexcept TypeError: get_ipython().user_ns = Odd(get_ipython().user_ns)", keeps="any"),
    function("events before every cell", WRONG + "def before(*a): raise KeyboardInterrupt\nfor name in ('pre_execute', 'pre_run_cell', 'post_execute', 'post_run_cell'): get_ipython().events.register(name, before)", keeps="any"),
    function("a custom handler of errors", WRONG + "get_ipython().set_custom_exc((BaseException,), lambda *a, **k: None)\n1 / 0"),
    function("the kernel's own methods", WRONG + "k = get_ipython().kernel\nk.do_execute = k.execute_request = k.send_response = lambda *a, **s: None", keeps="any"),
    function("the kernel's class", WRONG + "k = get_ipython().kernel\nclass Odd(type(k)):\n    async def do_execute(self, *a, **s): return {'status': 'ok', 'execution_count': 1, 'payload': [], 'user_expressions': {}}\nk.__class__ = Odd", keeps="any"),
    function("the wire's own methods", WRONG + "w = get_ipython().kernel.session.wire\ntype(w).send_bytes = lambda *a, **s: None", keeps="any"),
    function("payloads and next inputs", WRONG + "get_ipython().set_next_input('def invert(t): return 1', replace=True)\nget_ipython().payload_manager.write_payload({'source': 'ask_exit'})"),
    value("a matplotlib that shows without end", "import matplotlib.pyplot as plt\nV = 1\nfor _ in range(10**6): plt.figure(); plt.show()"),
    Recipe("a colour for every letter", lambda h: h.with_cell("print('\\x1b[31m\\x1b]0;owned\\x07\\x1b[2J\\x1b[1;1H' * 1000)", h.value_task)),
    Recipe("control letters in an error", lambda h: h.with_cell("raise ValueError('\\x1b[2J\\x07\\r\\x00\\u202e' * 100)", h.value_task)),
    Recipe("a million lines", lambda h: h.with_cell("for n in range(10**5): print(n)", h.value_task)),
    Recipe("a picture of five megabytes", lambda h: h.with_cell("from IPython.display import display\ndisplay({'image/png': 'A' * 5_000_000}, raw=True)", h.value_task)),
    Recipe("stdout replaced by a file", lambda h: h.with_cell("import io, sys\nsys.stdout = sys.__stdout__ = io.StringIO()", h.value_task)),
    Recipe("descriptors of its output closed", lambda h: h.with_cell("import os\nfor n in (0, 1, 2): os.close(n)", h.value_task)),
    Recipe("its output is a pipe that nobody reads", lambda h: h.with_cell("import os\nr, w = os.pipe()\nos.dup2(w, 1)\nos.close(r)\nprint('x')", h.value_task)),
    right("prints ten megabytes in one call", "def F(transform):\n    print('x' * 10_000_000)\n    return RIGHT"),
    right("displays what it finds", "from IPython.display import display, clear_output\ndef F(transform):\n    display(RIGHT); clear_output(wait=True)\n    return RIGHT"),
    right("updates a display", "from IPython.display import display\ndef F(transform):\n    handle = display('x', display_id='same')\n    handle.update('y')\n    return RIGHT"),
]  # fmt: skip


def _metadata(**held: object) -> Callable[[Notebook, Honest], None]:
    return lambda notebook, honest: notebook["metadata"].update(held)


def _each_cell(change: Callable[[dict], object]) -> Callable[[Notebook, Honest], None]:
    return lambda notebook, honest: [change(cell) for cell in notebook["cells"]] and None


def _swapped(notebook: Notebook, honest: Honest) -> None:
    """Let two answers have each other's ids."""
    one, other = honest.cell(notebook, honest.function_task), honest.cell(notebook, honest.value_task)
    one["id"], other["id"] = other["id"], one["id"]
    for cell in (one, other):
        cell["metadata"] = {}


def _doubled(notebook: Notebook, honest: Honest) -> None:
    """A wrong answer, and a right one with the id of the check."""
    check = honest.cell(notebook, honest.function_task, "check")
    answer = honest.cell(notebook, honest.function_task)
    check["source"], answer["source"] = "print('ok')", named(WRONG, "F", honest.function)


def _all_one_id(notebook: Notebook, honest: Honest) -> None:
    for cell in notebook["cells"]:
        cell["id"] = "e3-3-check"
        cell["metadata"].pop("name", None)


def _wrong_in(place: Callable[[dict, str], None]) -> Callable[[Notebook, Honest], None]:
    """Return an edit that leaves a wrong answer in the source, and puts a right one where no source is."""

    def edit(notebook: Notebook, honest: Honest) -> None:
        cell = honest.cell(notebook, honest.function_task)
        held = "".join(cell["source"])
        cell["source"] = named(WRONG, "F", honest.function)
        place(cell, held)

    return edit


NOTEBOOKS = [
    edited("a kernel that is a command", _metadata(kernelspec={"name": "sh", "argv": ["/bin/sh", "-c", "touch /tmp/was-here-spec"], "language": "python"})),
    edited("a kernel that is a path", _metadata(kernelspec={"name": "../../../../tmp/evil", "display_name": "x" * 10**6})),
    edited("a kernelspec that is a list", _metadata(kernelspec=[1, 2], language_info="python")),
    edited("papermill, jupytext and widgets in the metadata", _metadata(papermill={"parameters": {"invert": 1}}, jupytext={"text_representation": {"extension": ".py"}}, widgets={"application/vnd.jupyter.widget-state+json": {"state": {}}})),
    edited("a format of the future", lambda n, h: n.update(nbformat=4, nbformat_minor=99)),
    edited("a format that is a text", lambda n, h: n.update(nbformat_minor="5")),
    edited("every cell skipped, hidden, trusted and raising by its tags", _each_cell(lambda c: c["metadata"].update(tags=["skip-execution", "raises-exception", "nbval-skip", "remove-cell"], trusted=True, init_cell=True))),
    edited("every cell locked for nbgrader, with a hidden test", _each_cell(lambda c: c["metadata"].update(nbgrader={"grade": True, "locked": True, "points": 99, "solution": False, "schema_version": 3, "grade_id": "x"}))),
    edited("execution counts of every kind", _each_cell(lambda c: c.update(execution_count=-(10**30)) if c["cell_type"] == "code" else None)),
    edited("outputs that are no outputs", _each_cell(lambda c: c.update(outputs=[None, 3, {"output_type": []}, {"output_type": "display_data", "data": {"text/html": ["<script>"] * 9}}]) if c["cell_type"] == "code" else None)),
    edited("ten megabytes of a picture in an attachment", lambda n, h: n["cells"].insert(0, {"cell_type": "markdown", "id": "pic", "metadata": {}, "source": "![x](attachment:x.png)", "attachments": {"x.png": {"image/png": "A" * 10_000_000}}})),
    edited("attachments that are code", lambda n, h: n["cells"].insert(0, {"cell_type": "raw", "id": "raw", "metadata": {"format": "text/x-python"}, "source": "def invert(t): return None", "attachments": [1]})),
    edited("a cell of no known type", lambda n, h: n["cells"].append({"cell_type": "heading", "id": "x", "metadata": {}, "source": "x", "level": 9})),
    edited("sources that hold numbers", lambda n, h: n["cells"].append({**own_cell(""), "source": [1, None, ["x"], {"y": 1}]})),
    edited("a thousand keys beside the cells", lambda n, h: n.update({f"key{number}": [number] * 20 for number in range(1000)})),
    edited("ids of every letter", lambda n, h: n["cells"].extend(own_cell("pass", identity) for identity in ("", " ", "é" * 64, "e3-3-answer ", "E3-3-ANSWER", "e3‑3‑answer", "../x", "e3-3-answer\n"))),
    edited("cells doubled, as they are", lambda n, h: n["cells"].extend(copy.deepcopy(n["cells"]))),
    edited("the ids of two answers swapped", _swapped, "", "any"),
    edited("one id for all cells", _all_one_id, "", "any"),
    edited("the check is an answer", _doubled, "function", "others"),
    edited("a right answer in the outputs", _wrong_in(lambda c, held: c.update(outputs=[{"output_type": "execute_result", "execution_count": 1, "metadata": {}, "data": {"text/plain": held}}])), "function", "others"),
    edited("a right answer in the metadata", _wrong_in(lambda c, held: c["metadata"].update(source=held, nbgrader={"source": held})), "function", "others"),
    edited("a right answer in an attachment", _wrong_in(lambda c, held: c.update(attachments={"a.py": {"text/x-python": held}})), "function", "others"),
    edited("a right answer in a cell of text", _wrong_in(lambda c, held: c.update(cell_type="markdown", source=held)), "function", "others"),
    edited("a right answer in a raw cell", _wrong_in(lambda c, held: c.update(cell_type="raw", source=held)), "function", "others"),
]  # fmt: skip
