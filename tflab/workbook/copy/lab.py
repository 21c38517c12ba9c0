"""How is the workbook opened?  `tflab lab [DIR]`: a copy of your own, in a JupyterLab that talks to nobody else.

    tflab lab                 your copy in ./tflab_workbook, made the first time, opened every time
    tflab lab DIR --lang ko   another place, another language
    tflab lab --update        brings in new material; what you wrote stays
    tflab lab --from FOLDER   the same, with the exercises that your instructor has mended
    tflab lab DIR --as-is     any folder of notebooks; nothing is written there
    tflab lab --copy-only     makes the copy and starts nothing, for a JupyterLab that runs already
    tflab lab --no-browser    says where it is to be seen, instead of opening a browser
    tflab lab --port 9000     there
    tflab lab -- ...          what stands after -- goes to JupyterLab itself: --ip 0.0.0.0

JupyterLab would look for news, for updates and for extensions on the network;
here it does none of that.  Its terminals know the command `tflab`, a page saves the
last state of what moves in it, and pictures carry their words (`jupyter/`).
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from shlex import join, quote
from shutil import which

from tflab import __version__
from tflab.extras import require

from ...text import LANGUAGES, Text
from ..paths import COPY, MARK, WorkbookError, copy_at_hand, read_workbook
from .lay_out import Change, handed_out_in, has_language, lay_out, update

__all__ = ["FIRST_PAGE", "OUR_OPTIONS", "lab", "language_of", "our_environment"]

SETTINGS = Path(__file__).with_name("jupyter")
OUR_OPTIONS = (
    "--LabApp.news_url=None",
    "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
    "--LabApp.extension_manager=readonly",
    f"--LabApp.extra_labextensions_path={SETTINGS / 'labextensions'}",
    "--FileContentsManager.preferred_dir=",  # one of the user's own would lie outside of the copy
    "--LanguageServerManager.autodetect=False",  # jupyter-lsp, where it is, would ask npm
)
FIRST_PAGE = "00_start.ipynb"
PRIMARY_LANGUAGE, KOREAN = 0x3FF, 0x12  # of a Windows language identifier

MADE = Text(
    en="tflab lab: your own copy of the workbook is in {folder}.",
    ko="tflab lab: 내 워크북을 {folder}에 만들었습니다.",
)
OPENED = Text(
    en="tflab lab: opening your copy in {folder}.",
    ko="tflab lab: {folder}에 있는 내 워크북을 엽니다.",
)
BROUGHT_BACK = Text(en="  {page}: was missing, laid out again", ko="  {page}: 없어서 다시 만들었습니다")
OTHER_VERSION = Text(
    en="This copy was made by tflab {theirs}; you have tflab {ours}. It opens as it is.\n"
    "To bring in what is new: tflab lab {folder} --update (what you wrote stays).",
    ko="이 워크북은 tflab {theirs}로 만들었고, 지금 설치된 것은 tflab {ours}입니다. 일단 그대로 엽니다.\n"
    "새 내용을 받으려면 tflab lab {folder} --update를 실행하십시오. 직접 쓴 내용은 그대로 남습니다.",
)
UP_TO_DATE = Text(
    en="Nothing to bring in: everything is as in tflab {version}.",
    ko="받을 내용이 없습니다. 모두 tflab {version}과 같습니다.",
)
INSTRUCTORS = Text(
    en="The exercises stay in the language in which your instructor handed them out.",
    ko="연습 문제는 강사가 나눠 준 언어 그대로입니다.",
)
CHANGES = {
    "new": Text(en="new", ko="새 파일"),
    "replaced": Text(
        en="replaced by the new version; nothing in it was yours", ko="새 버전으로 바꿈(직접 쓴 내용 없음)"
    ),
    "merged": Text(
        en="new version, with {kept} of your cells kept", ko="새 버전으로 바꾸고 직접 쓴 셀 {kept}개를 남김"
    ),
    "kept": Text(
        en="yours is no notebook that tflab can read; it stays, and the new one is beside it",
        ko="읽을 수 없는 노트북이라 그대로 두고, 새 버전을 옆에 따로 저장함",
    ),
}
BESIDE = Text(
    en='; {beside} changed on both sides, look for "New in tflab"',
    ko=". {beside}개는 양쪽에서 바뀌었으니 “바뀐 내용입니다”를 찾아보십시오",
)
ROOT = Text(
    en="JupyterLab does not run as root unless it is told to: {command}",
    ko="JupyterLab은 root 계정에서는 따로 허락해야 열립니다: {command}",
)
BACKUP = Text(
    en="What was there before is in {folder}.",
    ko="바뀌기 전의 파일은 {folder}에 있습니다.",
)


def lab(words: Sequence[str]) -> int:
    """Open JupyterLab on a copy of the workbook, or on any folder as it is; return when it has ended."""
    given = list(words)
    words, own_options = _split(words)
    options = _parsed(words)
    if not options.copy_only:
        require("jupyterlab")
    if options.as_is:
        folder, language = Path(options.folder or ".").resolve(), language_of(os.environ)
        if not folder.is_dir():
            return _refuse(f"there is no folder {folder}")
        pages = [FIRST_PAGE]
    else:
        folder = _folder(options.folder).resolve()
        try:
            language = _prepare(folder, options.lang, options.update or bool(options.handed_out), options.handed_out)
        except (WorkbookError, OSError) as error:
            return _refuse(f"{error}")
        pages = [f"notebooks/{language}/{FIRST_PAGE}"]
        if options.copy_only:
            print(folder / pages[0])
            return 0
    root = f"--ServerApp.root_dir={folder}"  # whatever the user's own settings say
    first_page = [f"--LabApp.default_url=/lab/tree/{page}" for page in pages if (folder / page).exists()]
    own_options = [*_in_jupyterlabs_words(options), *own_options]
    os.chdir(folder)
    sys.stdout.flush()  # JupyterLab's own lines come after ours, also in a file
    tflab = "tflab" if which("tflab") else quote(sys.argv[0])  # as this shell knows it
    try:
        start_jupyterlab([*OUR_OPTIONS, root, *_terminal(), *first_page, *own_options])
    except SystemExit as stop:
        if stop.code == 1 and _is_root() and "--allow-root" not in own_options:
            return _refuse(ROOT.say(language, command=f"{tflab} lab {join(_with_root(given))}"))
        raise
    return 0


def language_of(environment: Mapping[str, str]) -> str:
    """Return "ko" where the locale is Korean, else "en"."""
    for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if environment.get(name):
            return "ko" if environment[name].lower().startswith("ko") else "en"
    return "ko" if _windows_speaks_korean() else "en"


def _windows_speaks_korean() -> bool:
    """Return whether the language of Windows is Korean; it says so in no variable."""
    if os.name != "nt":
        return False
    import ctypes

    return ctypes.windll.kernel32.GetUserDefaultUILanguage() & PRIMARY_LANGUAGE == KOREAN


def _terminal() -> list[str]:
    """Return the option for a shell that keeps our PATH: without a terminal of its own Jupyter starts a login shell."""
    if os.name != "posix" or sys.stdout.isatty():
        return []
    return [f"--ServerApp.terminado_settings={{'shell_command': ['{os.environ.get('SHELL') or 'sh'}']}}"]


def start_jupyterlab(options: Sequence[str]) -> None:
    """Run JupyterLab in this very process, so that whatever ends this one ends it too."""
    from jupyterlab.labapp import main

    commands = os.path.dirname(sys.executable)  # where `tflab` is, for the terminals and for `!tflab`
    os.environ["PATH"] = os.pathsep.join(filter(None, [commands, os.environ.get("PATH")]))
    os.environ.update(our_environment(os.environ))
    main(list(options))


def our_environment(environment: Mapping[str, str]) -> dict[str, str]:
    """Return what to add to an environment: JupyterLab asks for no news, and keeps the state of widgets."""
    paths = [str(SETTINGS), *filter(None, [environment.get("JUPYTER_CONFIG_PATH")])]
    return {"JUPYTER_CONFIG_PATH": os.pathsep.join(paths)}


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="tflab lab",
        usage="tflab lab [DIR] [option ...] [-- option of JupyterLab ...]",
        description="Open your copy of the workbook, offline.",
        epilog="What stands after -- goes to JupyterLab itself: tflab lab -- --ip 0.0.0.0",
    )
    parser.add_argument(
        "folder", nargs="?", metavar="DIR", help=f"where your copy is, or will be; ./{COPY} if left out"
    )
    parser.add_argument("--lang", choices=LANGUAGES, help="of the pages; that of the locale for a new copy")
    parser.add_argument("--update", action="store_true", help="bring in new material; what you wrote stays")
    parser.add_argument(
        "--from",
        dest="handed_out",
        metavar="FOLDER",
        help="bring in what your instructor mended; your answers stay",
    )
    parser.add_argument("--as-is", action="store_true", help="open DIR as any folder of notebooks, and write nothing")
    parser.add_argument("--copy-only", action="store_true", help="make the copy, say where its first page is, and end")
    parser.add_argument("--port", type=int, help="of JupyterLab's, if 8888 is not to be the first that it tries")
    parser.add_argument("--no-browser", action="store_true", help="print the address instead of opening a browser")
    return parser


def _parsed(words: Sequence[str]) -> argparse.Namespace:
    """Return our own options; whatever is none of them ends it, with where one of JupyterLab's stands."""
    parser = _parser()
    options, unknown = parser.parse_known_args(words)
    if unknown:
        behind = "an option of JupyterLab stands after --, as in: tflab lab -- --ip 0.0.0.0"
        parser.error(f"unrecognized arguments: {' '.join(unknown)}; {behind}")
    return options


def _in_jupyterlabs_words(options: argparse.Namespace) -> list[str]:
    """Return those of our options that JupyterLab has, too."""
    browser = ["--no-browser"] if options.no_browser else []
    return browser + ([f"--ServerApp.port={options.port}"] if options.port is not None else [])


def _folder(named: str | None) -> Path:
    """Return the copy to open: the named one, the one that we are in, or the one below this folder."""
    return Path(named) if named else copy_at_hand() or Path.cwd() / COPY


def _prepare(folder: Path, language: str | None, bring_in: bool, handed_out: str | None = None) -> str:
    """Make or open the copy, say so, and return its language."""
    if handed_out and not (folder / MARK).is_file():
        raise WorkbookError(f"there is no copy in {folder} to bring anything into; open {handed_out} itself")
    if not folder.parent.is_dir():
        raise WorkbookError(f"there is no folder {folder.parent} to put a copy into")
    if (folder / MARK).is_file():
        return _open(folder, language, bring_in, handed_out)
    language = language or language_of(os.environ)
    try:
        lay_out(folder, language)
    except WorkbookError as error:
        raise WorkbookError(f'{error}\nTo open it as it is: tflab lab "{folder}" --as-is') from None
    print(MADE.say(language, folder=folder))
    return language


def _open(folder: Path, language: str | None, bring_in: bool, handed_out: str | None) -> str:
    found = read_workbook(folder)
    new = handed_out_in(Path(handed_out).resolve(), folder) if handed_out else {}
    language = language or found.language
    print(OPENED.say(language, folder=folder))
    if language != found.language or (found.tflab == __version__ and not bring_in):
        before = _pages(folder)
        lay_out(folder, language)  # what is missing
        for page in sorted(_pages(folder) - before) if language == found.language else ():
            print(BROUGHT_BACK.say(language, page=page))
    if found.edition == "class" and not (folder / "exercises" / language).is_dir():
        print(INSTRUCTORS.say(language))
    if bring_in:
        _tell(update(folder, new), folder, language)
    elif found.tflab != __version__:
        print(OTHER_VERSION.say(language, theirs=found.tflab, ours=__version__, folder=folder))
    return language if has_language(folder, language) else found.language


def _pages(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.glob("*/*/*.ipynb")}


def _tell(changes: Sequence[Change], folder: Path, language: str) -> None:
    if not changes:
        print(UP_TO_DATE.say(language, version=__version__))
        return
    for change in changes:
        said = CHANGES[change.what].say(language, kept=change.kept)
        print(f"  {change.path}: {said}{BESIDE.say(language, beside=change.beside) if change.beside else ''}")
    backups = sorted((folder / ".tflab" / "backups").glob("*"), key=lambda path: path.name.zfill(9))
    if backups and any(change.what in ("replaced", "merged") for change in changes):
        print(BACKUP.say(language, folder=backups[-1]))


def _is_root() -> bool:
    return hasattr(os, "geteuid") and os.geteuid() == 0


def _with_root(words: list[str]) -> list[str]:
    """Return what was typed, with JupyterLab allowed to run as root."""
    return [*words, *([] if "--" in words else ["--"]), "--allow-root"]


def _refuse(reason: str) -> int:
    print(f"tflab lab: {reason}", file=sys.stderr)
    return 2


def _split(words: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the words before the first `--`, and those after it."""
    words = list(words)
    if "--" not in words:
        return words, []
    return words[: words.index("--")], words[words.index("--") + 1 :]
