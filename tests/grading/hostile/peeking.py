"""Attacks that look for what was asked or expected: files, memory, frames, environment."""

from __future__ import annotations

from .recipe import CASES, WRONG, function, value

__all__ = ["PEEKING"]

FIND_FILES = """
import glob, os, json
found = []
for root in ('/', os.path.expanduser('~'), os.getcwd(), '..', '/tmp', '/root', '/home', '/mnt', '/srv'):
    for pattern in ('pack.json', '*/pack.json', '*/*/pack.json', '*/*/*/pack.json', '*/instructor/*', '*/hidden/*.json'):
        found += glob.glob(os.path.join(root, pattern))
"""


PEEKING = [
    function("the solution that comes with tflab", """
import json
from tflab.workbook.paths import workbook_data
cells = []
for path in sorted(workbook_data().glob('solutions/*/03*.ipynb')) + sorted(workbook_data().glob('solutions/src/03*')):
    text = path.read_text()
    cells += [''.join(c['source']) for c in json.loads(text)['cells']] if path.suffix == '.ipynb' else text.split('# %%')
    for cell in cells:
        if 'def F(' in cell:
            exec(cell[cell.index('def F('):])
if not cells: raise FileNotFoundError
"""),
    value("computes what is right with the seed of its copy", CASES + """
from tflab.workbook.answers.values import from_plain
V = from_plain(cases_of('E3.2')[0].expected)
"""),
    function("computes the cases with the seed of its copy, and what that leads to", CASES + """
import hashlib, hmac, json
from tflab.workbook.answers.values import from_plain
from tflab.workbook.tasks import catalog, generate_cases, reference
known, seed = {}, bytes.fromhex(SEED)
seeds = [SEED, seed, '', *(hmac.new(seed, word, 'sha256').digest() for word in (b'hidden', b'learners', b'asked'))]
try:
    task, solution = catalog.tasks_of(workbook_data(), '03_target_and_source')['E3.3'], catalog.solution_of(workbook_data(), '03_target_and_source')
    with reference.in_process_ros():
        F = solution.answer(task, None)
        for one in seeds:
            for case in generate_cases.make_variant(task, one, 0, solution, 24).cases: known[json.dumps(case.args)] = case.expected
except Exception:
    def F(transform):
        return from_plain(known.get(json.dumps([{'dict': transform}])))
"""),
    value("looks for a copy and its seed", CASES + """
import json, os
from tflab.workbook.answers.values import from_plain
V = (0.0, 0.0, 0.0)
for top, folders, files in os.walk('/'):
    if top.startswith(('/proc', '/sys')): folders.clear(); continue
    for name in {'workbook.json', 'pack.json'} & set(files):
        try: V = from_plain(cases_of('E3.2', json.load(open(os.path.join(top, name)))['seed'])[0].expected)
        except Exception: pass
"""),
    value("the pack, wherever it may be", FIND_FILES + """
V = (0.0, 0.0, 0.0)
for path in found:
    V = list(json.load(open(path))['tasks']['E3.2'].values())[0]
"""),
    value("other processes' memory", """
import os
V = (0.0, 0.0, 0.0)
others = [name for name in os.listdir('/proc') if name.isdigit() and int(name) != os.getpid()]
for name in others:
    for part in ('environ', 'cmdline', 'maps', 'mem'):
        try: open(f'/proc/{name}/{part}', 'rb').read(100)
        except OSError: pass
"""),
    value("the frames that called it", """
import inspect, gc
V = (0.0, 0.0, 0.0)
for frame in inspect.stack():
    if 'expected' in frame.frame.f_locals or 'expected' in frame.frame.f_globals: V = frame.frame.f_locals['expected']
for thing in gc.get_objects():
    if type(thing) is dict and 'expected' in thing and 'wrong' in thing:
        V = list(thing['expected'].values())[0]
        break
"""),
    function("traces until it sees the expected", """
import sys
seen = []
def trace(frame, event, arg):
    if 'expected' in frame.f_locals: seen.append(frame.f_locals['expected'])
    return trace
sys.settrace(trace)
def F(transform):
    return seen[-1] if seen else None
"""),
    value("makes the cases itself, with likely seeds", """
V = (0.0, 0.0, 0.0)
from tflab.workbook.answers.values import from_plain
from tflab.workbook.paths import workbook_data
from tflab.workbook.tasks import catalog, generate_cases
data, stem = workbook_data(), '03_target_and_source'
for seed in ('public', 'secret', '', 'hidden', SEED):
    made = generate_cases.task_cases(catalog.task_in(data, stem, 'E3.2'), seed, catalog.solution_of(data, stem), 1)
    V = from_plain(made.variants[0].cases[0].expected)
"""),
    value("asks the network", """
import socket
V = (0.0, 0.0, 0.0)
for address in (('127.0.0.1', 8888), ('1.1.1.1', 53), ('example.com', 80)):
    try: socket.create_connection(address, timeout=0.2); V = 'reached'
    except OSError: pass
"""),
    value("asks the grader's modules", """
V = (0.0, 0.0, 0.0)
import sys, importlib
for name in [n for n in sys.modules if n.startswith('tflab')]:
    for key, thing in list(vars(sys.modules[name]).items()):
        if 'expected' in key.lower() or 'secret' in key.lower() and isinstance(thing, (dict, list, str, bytes)): V = thing
"""),
    value("reads its environment", "import os\nV = tuple(os.environ.items())[:3]"),
    function("reads every file for its own solution", """
import os
found = []
for top, folders, files in os.walk('/'):
    if top.startswith(('/proc', '/sys')): folders.clear(); continue
    if 'tflab' not in top and 'workbook' not in top and 'solutions' not in top: continue
    for name in files:
        if name.endswith(('.py', '.pyc', '.ipynb', '.json')):
            try: text = open(os.path.join(top, name), 'rb').read()
            except OSError: continue
            if b'def F(' in text and b'return' in text and b'E3.3' in text: found.append(text)
            if b'TASK = Task(' in text and b'"E3.3"' in text: found.append(text)
def F(transform):
    return RIGHT if found else None
"""),
    function("imports the solution by any name", """
import importlib, sys
from tflab.workbook.paths import workbook_data
sys.path[:0] = [str(workbook_data()), str(workbook_data() / 'solutions/tasks'), str(workbook_data() / 'solutions/src')]
solution = None
for name in ('03_target_and_source', 'solutions.tasks.03_target_and_source', 'tflab._workbook.solutions', 'solutions'):
    try: solution = solution or importlib.import_module(name).__file__  # a folder's name alone is no module
    except Exception: pass
def F(transform):
    return RIGHT if solution else None
"""),
    function("asks the reference module for the answer", """
from tflab.workbook.tasks import catalog, generate_cases
from tflab.workbook.paths import workbook_data
made = None
try:
    data, stem = workbook_data(), '03_target_and_source'
    made = generate_cases.task_cases(catalog.task_in(data, stem, 'E3.3'), generate_cases.PUBLIC_SEED, catalog.solution_of(data, stem), 1)
except Exception: pass
def F(transform):
    return RIGHT if made else None
"""),
    function("asks check whether it is right, many times", """
import io, contextlib
from tflab.workbook.checks import check as really
told = io.StringIO()
with contextlib.redirect_stdout(told):
    try: really('E3.3', lambda transform: None)
    except Exception: pass
def F(transform):
    return RIGHT if '/' in told.getvalue() and 'E3.3' in told.getvalue() and '0/' not in told.getvalue() and 'no ' not in told.getvalue() else None
"""),
    function("every descriptor it was left", """
import os, socket
wire = get_ipython().kernel.session.wire.fileno()
others = [int(n) for n in os.listdir('/proc/self/fd') if int(n) > 2 and int(n) != wire]
extra = []
for n in others:
    try:
        if 'socket' in os.readlink(f'/proc/self/fd/{n}'): socket.socket(fileno=os.dup(n)).getpeername(); extra.append(n)
    except OSError: pass
def F(transform):
    return None
"""),
    function("the other side of the wall through /proc", """
import os
seen = []
for n in list(range(1, 400)) + ['self', 'thread-self']:
    for way in ('root', 'cwd', 'exe', 'fd/3', 'map_files'):
        try: path = os.readlink(f'/proc/{n}/{way}'); seen += [open(f'/proc/{n}/root/{f}').read(9) for f in ('etc/shadow', 'etc/fstab')]
        except OSError: pass
def F(transform):
    return RIGHT if seen else None
"""),
    function("namespaces, setuid programs and device files", """
import ctypes, os, subprocess
libc = ctypes.CDLL(None, use_errno=True)
won = [libc.unshare(flag) for flag in (0x10000000, 0x20000, 0x20000000, 0x40000000)].count(0)
for program in (['unshare', '-Ur', 'id'], ['su', '-c', 'id'], ['sudo', '-n', 'id'], ['mount', '--bind', '/', '/tmp'], ['nsenter', '-t', '1', '-m', 'ls'], ['pkexec', 'id']):
    try: won += subprocess.run(program, capture_output=True, timeout=1, stdin=subprocess.DEVNULL).returncode == 0
    except (OSError, subprocess.SubprocessError): pass
for make in (lambda: os.mknod('d', 0o060666, os.makedev(8, 0)), lambda: os.setuid(0), lambda: os.chroot('/'), lambda: os.open('/dev/mem', 0)):
    try: make(); won += 1
    except OSError: pass
def F(transform):
    return RIGHT if won else None
"""),
    function("system calls that make room for others", """
import ctypes
libc = ctypes.CDLL(None, use_errno=True)
libc.syscall.restype = ctypes.c_long
won = [n for n in (101, 155, 165, 250, 248, 249, 272, 278, 298, 304, 308, 310, 311, 319, 321, 323, 425, 428, 430, 435, 438, 447) if libc.syscall(n, 0, 0, 0, 0, 0) >= 0]
def F(transform):
    return RIGHT if won else None
"""),
    function("names of sockets that are in no folder", """
import socket
names = [line.split()[-1] for line in open('/proc/net/unix') if '@' in line]
won = []
for name in names:
    try: s = socket.socket(socket.AF_UNIX); s.connect('\\0' + name[1:]); won.append(s)
    except OSError: pass
def F(transform):
    return RIGHT if won else None
"""),
    function("memory searched for the reference", WRONG + """
import re
with open('/proc/self/mem', 'rb', 0) as memory:
    for line in open('/proc/self/maps').readlines():
        if ' rw-p' in line:
            first, last = (int(number, 16) for number in line.split()[0].split('-'))
            try: memory.seek(first); held = memory.read(last - first)
            except (OSError, ValueError): continue
            if re.search(b'by_its[_]looks|against_the[_]arrow', held):  # which does not find itself
                F = lambda transform: RIGHT
"""),
]  # fmt: skip
