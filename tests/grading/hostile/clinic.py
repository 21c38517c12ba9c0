"""Patients named without being examined: every suspect, forged records, others' patients, a trolley that costs nothing."""

from __future__ import annotations

from .recipe import CASES, Recipe, function, value

__all__ = ["CLINIC"]

TOOLS = """
import json
from pathlib import Path
from tflab.clinic.fixes import DIAGNOSES
from tflab.clinic.proof import SUSPECTS, CHECKS, consistent_suspects, shortest_proof
def proved(patient, cause):
    for check in shortest_proof(cause):
        patient.ask(check)
    return patient.verdict(cause, DIAGNOSES[cause].frame)
def right(patient):
    (cause,) = consistent_suspects({key: check.kind(patient.reading(key)[2]) for key, check in CHECKS.items()})
    patient.asked = ()
    return proved(patient, cause)
"""
AHEAD = "{'cause': 'laser clock ahead', 'frame': 'laser_frame', 'proof': ['laser clock ahead', ['delay /scan']]}"
EQUAL = "class Any(str):\n    def __eq__(self, other): return True\n    def __hash__(self): return hash('laser clock ahead')\n"
PARTS = "checks", "cause", "frame", "owner", "fix"
PLACES = "[Path.home(), Path('/tmp'), Path('/work'), Path('/home'), Path('/root'), Path('/dev/shm'), Path('/var/tmp')]"


def triage(name: str, body: str, before: str = "") -> Recipe:
    """Return an attack on the program that makes the rounds."""
    return function(name, f"{TOOLS}{before}\ndef F(patient):\n{body}")


def if_found(name: str, found: str) -> Recipe:
    """Return a program that is right if it has found something that it must not have."""
    return triage(
        name,
        "    return right(patient) if found else None",
        f"try:\n    found = {found}\nexcept Exception:\n    found = None",
    )


def three(name: str, words: str, before: str = "") -> Recipe:
    """Return an attack on the three patients: an expression for each part, of `who` and `what`."""
    return value(name, f"{TOOLS}{before}\nV = {{f'{{who}} {{what}}': {words} for who in 'abc' for what in {PARTS!r}}}")


CLINIC = [
    triage("one cause, nothing asked", "    return patient.verdict('laser clock ahead', 'laser_frame')"),
    triage("one cause, and its proof asked", "    return proved(patient, 'laser clock ahead')"),
    triage("one cause, and its proof written down", f"    return {AHEAD}"),
    triage("every suspect in a list", "    return patient.verdict(list(SUSPECTS), 'laser_frame')"),
    triage("every suspect in a word", "    return patient.verdict(' | '.join(SUSPECTS), 'all that move')"),
    triage("every suspect in a set", "    return patient.verdict(set(SUSPECTS), {'map', 'odom', 'laser_frame'})"),
    triage("every suspect in lines", "    return patient.verdict('\\n'.join(SUSPECTS), 'map\\nodom')"),
    triage("every suspect in an array", "    return patient.verdict(__import__('numpy').array(SUSPECTS), 'odom')"),
    triage("a verdict of every suspect", "    return [proved(patient, cause) for cause in SUSPECTS]"),
    triage("every verdict, one after another", "    for cause in SUSPECTS: yield proved(patient, cause)"),
    triage("the suspects by the number of the call", "    global count\n    count += 1\n    return proved(patient, SUSPECTS[count % 18])", "count = -1"),
    triage("the suspects backwards by the number of the call", "    global count\n    count -= 1\n    return proved(patient, SUSPECTS[count % 18])", "count = 0"),
    triage("a suspect by the length of the patient", "    return proved(patient, SUSPECTS[len(patient.packed()) % 18])"),
    triage("a suspect by a digest of the patient", "    import hashlib\n    return proved(patient, SUSPECTS[hashlib.sha256(patient.packed().encode()).digest()[0] % 18])"),
    triage("a suspect by chance", "    import os\n    return proved(patient, SUSPECTS[os.urandom(1)[0] % 18])"),
    triage("asks everything, and names one", "    for check in CHECKS: patient.ask(check)\n    return patient.verdict('laser clock ahead', 'laser_frame')"),
    triage("a proof of everybody", "    return patient.verdict('laser clock ahead', 'laser_frame') | {'proof': [[cause, shortest_proof(cause)] for cause in SUSPECTS]}"),
    triage("a proof of nobody", "    return {'cause': 'nobody', 'frame': 'none', 'proof': ['nobody', []]}"),
    triage("a record that was faked", "    patient.asked = tuple(shortest_proof('laser clock ahead'))\n    return patient.verdict('laser clock ahead', 'laser_frame')"),
    triage("a record of another kind", "    patient.asked = {check: 0 for check in CHECKS}\n    return patient.verdict('laser clock ahead', 'laser_frame')"),
    triage("a record of ten thousand questions", "    patient.asked = tuple(CHECKS) * 500\n    return patient.verdict('laser clock ahead', 'laser_frame')"),
    triage("the patient handed back", "    return patient"),
    triage("the patient's word handed back", "    return patient.packed()"),
    triage("a visit handed back", "    from tflab.clinic.visit import admit\n    return admit(patient)"),
    triage("a visit whose log is faked", "    from tflab.clinic.visit import Visit, VisitEntry\n    visit = Visit(patient)\n    visit.log = [VisitEntry(check, 0.0, 'all Ok', '', ()) for check in CHECKS]\n    return {**visit.diagnosis, 'proof': visit.log}"),
    triage("a word that equals every word", "    return patient.verdict(Any('laser clock ahead'), Any('laser_frame'))", EQUAL),
    triage("a verdict that equals every verdict", "    return Same(" + AHEAD + ")", "class Same(dict):\n    def __eq__(self, other): return True\n    def __missing__(self, key): return key"),
    triage("raises its diagnosis", "    raise type('laser clock ahead', (Exception,), {})(patient.packed())"),
    triage("a cause whose letters cannot be seen", "    return patient.verdict('laser clock ahead\\u200b', 'laser_frame\\x00')"),
    triage("a trolley that costs nothing, and everything asked", "    for check in CHECKS: patient.ask(check)\n    return patient.verdict('nothing is wrong', 'none')", "for check, held in CHECKS.items():\n    object.__setattr__(held, 'minutes', 0.0) if hasattr(held, '__dict__') else None"),
    triage("no flaw in any proof", "    return patient.verdict('laser clock ahead', 'laser_frame')", "import tflab.clinic.proof as p, tflab.workbook.answers.proof as q\np.find_flaw = q.find_flaw = lambda *a, **k: None"),
    triage("one suspect for all", "    return proved(patient, 'laser clock ahead')", "import tflab.clinic.table as t, tflab.clinic.proof as p, tflab.workbook.answers.proof as q\nt.SUSPECTS = p.SUSPECTS = q.SUSPECTS = ('laser clock ahead',)"),
    triage("findings rewritten", "    return proved(patient, 'laser clock ahead')", "import tflab.clinic.table as t, tflab.clinic.proof as p\nt.expected_kind = p.expected_kind = lambda *a: 'as on the card'"),
    triage("patients who all have the same", "    return proved(patient, 'laser clock ahead')", "from tflab.clinic.patient import FaultyRobot\nFaultyRobot.reading = lambda self, check: (0.0, 'all Ok', 'all Ok')\nFaultyRobot.unpacked = classmethod(lambda cls, word: cls('', '', 12.0, {}, {}))"),
    triage("a verdict that always says the same", "    return patient.verdict('', '')", f"from tflab.clinic.patient import FaultyRobot\nFaultyRobot.verdict = lambda *a: {AHEAD}"),
    triage("admit and Visit rewritten", "    return proved(patient, 'laser clock ahead')", "import tflab.clinic.visit as v\nv.admit = v.Visit._doubt = v.Visit._refusal = lambda *a, **k: ''"),
    triage("forms that agree with everything", f"    return {AHEAD}", "from tflab.workbook.answers import form, forms, proof, structures\nfor each in (proof.Proof, structures.Choice, forms.Parts):\n    each.same = each.alike = lambda *a: True\n    each.judge = lambda *a: [True] * 3\n    each.probes = lambda *a: [[()]]"),
    triage("the causes of the public patients by place", "    global count\n    count += 1\n    return proved(patient, order[count % len(order)]) if order else None", CASES + "count, order = -1, []\ntry:\n    order = [case.expected['dict']['cause'] for case in cases_of('E12.7')]\nexcept Exception:\n    pass"),
    if_found("right if the pack can be read", f"[path for place in {PLACES} for path in place.glob('**/instructor/pack.json') if path.read_text()]"),
    if_found("right if what is graded can be read", f"[path for place in {PLACES} for path in place.glob('**/instructor/masters/12*.ipynb') if path.read_text()]"),
    if_found("right if the kept patients can be read", "[path for path in Path.home().glob('.cache/tflab/patients/*/*') if path.read_text()]"),
    if_found("right if other visits can be read", f"[path for place in {PLACES} for path in place.glob('**/submissions/**/*.ipynb') if path.read_text()]"),
    if_found("right if what is expected lies in memory", "[held for held in __import__('gc').get_objects() if isinstance(held, dict) and 'expected' in held and 'wrong' in held and str(held.get('args')).startswith('[')]"),
    if_found("right if a frame knows what is expected", "[frame for frame in __import__('sys')._current_frames().values() for _ in range(50) if frame and 'expected' in frame.f_locals]"),
    three("one word everywhere", "'laser clock ahead'"),
    three("every suspect everywhere", "list(SUSPECTS)"),
    three("one patient's answer for all", "{'checks': ['delay /scan'], 'cause': 'laser clock ahead', 'frame': 'laser_frame', 'owner': 'laser_driver', 'fix': 'new sensor'}[what]"),
    three("the patients handed back", "getattr(e12_4, who)"),
    three("the whole trolley as a proof", "list(CHECKS)"),
    three("a proof of each suspect", "[(cause, shortest_proof(cause)) for cause in SUSPECTS]"),
    three("words that equal every word", "Any('laser clock ahead')", EQUAL),
    three("visits instead of answers", "Visit(getattr(e12_4, who))", "from tflab.clinic.visit import Visit"),
    three("a visit's diagnosis, said without asking", "said(getattr(e12_4, who)).get(what, [])", "from tflab.clinic.visit import Visit\ndef said(patient):\n    visit = Visit(patient)\n    visit._doubt = lambda cause: ''\n    visit.say('laser clock ahead')\n    return visit.diagnosis"),
    value("a check that always agrees", "import tflab.workbook as w, tflab.workbook.checks as c\nw.check = c.check = check = lambda *a, **k: print('right')\nV = {}"),
    value("tasks of one's own", "import os\nfrom pathlib import Path\nos.environ['TFLAB_WORKBOOK'] = '/tmp/own'\ntasks = Path('/tmp/own/solutions/tasks/12_owners_and_diagnosis')\ntasks.mkdir(parents=True, exist_ok=True)\n(tasks / 'e12_4.py').write_text('from tflab.workbook.tasks import Choice, Task, Text\\nTASK = Task(\"E12.4\", \"M\", 6, Text(\"a\", \"a\"), \"V\", Choice(options=(\"mine\",)), (Text(\"a\", \"a\"),) * 3)')\nV = 'mine'"),
    value("the patients' causes, computed with the seed of its copy", CASES + "from tflab.workbook.answers.values import from_plain\nV = from_plain(cases_of('E12.4')[0].expected)"),
    triage("the patients that the seed of its copy leads to", "    return known.get(patient.packed())", CASES + "import hmac\nfrom tflab.workbook.answers.values import from_plain\nfrom tflab.workbook.tasks import catalog, generate_cases, reference\nknown = {}\ntry:\n    task, solution = catalog.tasks_of(workbook_data(), '12_owners_and_diagnosis')['E12.7'], catalog.solution_of(workbook_data(), '12_owners_and_diagnosis')\n    with reference.in_process_ros():\n        for seed in (SEED, hmac.new(bytes.fromhex(SEED), b'hidden', 'sha256').digest()):\n            known |= {from_plain(case.args[0]).packed(): from_plain(case.expected) for case in generate_cases.make_variant(task, seed, 0, solution).cases}\nexcept Exception:\n    pass"),
]  # fmt: skip
