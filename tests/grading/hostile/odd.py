"""Right answers, oddly written."""

from __future__ import annotations

from .recipe import answered, edited, right

__all__ = ["ODD"]

MOVED = "p = e3_2.base_T_laser.apply(e3_2.laser_p_corner)\nm = e3_2.map_T_base.apply(p)\n"


ODD = [
    right("prints a lot", "def F(transform):\n    print('thinking ' * 20000)\n    return RIGHT"),
    right("warns", "import warnings\ndef F(transform):\n    warnings.warn('careful')\n    return RIGHT"),
    right("writes to stderr", "import sys\ndef F(transform):\n    print('careful', file=sys.stderr)\n    return RIGHT"),
    right("returns numbers of NumPy", """
import numpy as np
def F(transform):
    return {name: np.float64(number) for name, number in (RIGHT).items()}
"""),
    right("returns arrays without dimensions", """
import numpy as np
def F(transform):
    return {name: np.array(number) for name, number in (RIGHT).items()}
"""),
    right("a whole turn more", """
def F(transform):
    back = RIGHT
    back['yaw'] += 2 * math.pi
    return back
"""),
    right("something besides", "def F(transform):\n    return {**RIGHT, 'note': 'turned back first'}"),
    right("another kind of dict", "import collections\ndef F(transform):\n    return collections.OrderedDict(RIGHT)"),
    right("a class that can be called", """
class Inverter:
    def __call__(self, transform):
        return RIGHT
F = Inverter()
"""),
    right("a partial function", "import functools\ndef _f(power, transform):\n    return RIGHT\nF = functools.partial(_f, -1)"),
    right("remembers earlier calls", """
seen = {}
def F(transform):
    key = tuple(transform.values())
    return seen.setdefault(key, RIGHT)
"""),
    right("defines itself twice", "def F(transform):\n    return None\ndef F(transform):\n    return RIGHT"),
    right("annotated to the teeth", "def F(transform: 'Transform') -> 'Transform':\n    '''Return the inverse.'''\n    return RIGHT"),
    right("a generator inside", "def F(transform):\n    return next(RIGHT for transform in [transform])"),
    right("plots as it works", """
import matplotlib.pyplot as plt
def F(transform):
    plt.figure(); plt.plot([0, 1]); plt.close()
    return RIGHT
"""),
    right("calls check itself", "def F(transform):\n    return RIGHT\nfrom tflab.workbook import check\ncheck('E3.3', F)"),
    right("waits a little", "import time\ndef F(transform):\n    time.sleep(0.02)\n    return RIGHT"),
    right("uses a thread", """
from concurrent.futures import ThreadPoolExecutor
def F(transform):
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(lambda: RIGHT).result()
"""),
    right("a dataclass", "from dataclasses import dataclass\n@dataclass(frozen=True, slots=True)\nclass Place:\n    x: float\n    y: float\n    yaw: float\ndef F(transform):\n    return Place(**RIGHT)"),
    right("keys that are an Enum of texts", "import enum\nclass Key(str, enum.Enum):\n    X = 'x'\n    Y = 'y'\n    YAW = 'yaw'\ndef F(transform):\n    return {key: RIGHT[key.value] for key in Key}"),
    right("vectorized", "import numpy as np\n@np.vectorize\ndef F(transform):\n    return RIGHT"),
    right("arrays of objects", "import numpy as np\ndef F(transform):\n    return {name: np.array(number, dtype=object) for name, number in (RIGHT).items()}"),
    right("lines that end in CR", "def F(transform):\r    return RIGHT\r"),
    right("a question mark at the end", "def F(transform):\n    return RIGHT\nF??"),
    right("an error behind it", "def F(transform):\n    return RIGHT\nassert F(None)"),
    answered("texts in arrays", "E3.1", "import numpy as np\ncalls = {name: np.array(pair.split()) for name, pair in {'a': 'map laser_frame', 'b': 'base_link map', 'c': 'base_link camera_link', 'd': 'laser_frame base_link'}.items()}"),
    answered("iterators for lists", "E3.2", MOVED + "corner = {'base_link': map(float, p), 'map': (number for number in m)}"),
    answered("views for lists", "E3.2", MOVED + "corner = {'base_link': dict(zip('xyz', p)).values(), 'map': dict(zip('xyz', m))}"),
    edited("a magic above every answer", lambda n, h: [c.update(source="%%time\n" + "".join(c["source"])) for c in n["cells"] if c["id"].endswith("-answer")]),
    right("starts processes, and waits for them", "import subprocess, sys\ndef F(transform):\n    subprocess.run([sys.executable, '-c', 'pass'], check=True)\n    return RIGHT"),
    right("writes files and reads them", "import json, tempfile, pathlib\ndef F(transform):\n    path = pathlib.Path(tempfile.mkdtemp()) / 'x.json'\n    path.write_text(json.dumps(RIGHT))\n    return json.loads(path.read_text())"),
    right("a pool of processes", "from multiprocessing import get_context\ndef one(n): return n\ndef F(transform):\n    with get_context('fork').Pool(2) as pool:\n        assert pool.map(one, [1, 2]) == [1, 2]\n    return RIGHT"),
]  # fmt: skip
