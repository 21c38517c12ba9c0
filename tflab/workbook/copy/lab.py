"""Open the learner's copy in a JupyterLab without network: `tflab lab [DIR]`.

    tflab lab                 your copy in ./tflab_workbook, made the first time, opened every time
    tflab lab DIR --lang ko   another place, another language
    tflab lab --update        brings in new material; what you wrote stays
    tflab lab --from FOLDER   the same, with the exercises that your instructor has corrected
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

from ...text import LANGUAGES, Texts, language_of_locale
from ..paths import COPY, MARK, WorkbookError, copy_at_hand, read_workbook
from .lay_out import Change, handed_out_in, has_language, lay_out, update

__all__ = ["FIRST_PAGE", "OUR_OPTIONS", "lab", "our_environment"]

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

TEXTS = Texts(__file__)


def lab(words: Sequence[str]) -> int:
    """Open JupyterLab on a copy of the workbook, or on any folder as it is; return when it has ended."""
    given = list(words)
    words, own_options = _split(words)
    options = _parsed(words)
    if not options.copy_only:
        require("jupyterlab")
    if options.as_is:
        folder, language = Path(options.folder or ".").resolve(), language_of_locale(os.environ)
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
            return _refuse(TEXTS["root"].say(language, command=f"{tflab} lab {join(_with_root(given))}"))
        raise
    return 0


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
        help="bring in what your instructor corrected; your answers stay",
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
    language = language or language_of_locale(os.environ)
    try:
        lay_out(folder, language)
    except WorkbookError as error:
        raise WorkbookError(f'{error}\nTo open it as it is: tflab lab "{folder}" --as-is') from None
    print(TEXTS["made"].say(language, folder=folder))
    return language


def _open(folder: Path, language: str | None, bring_in: bool, handed_out: str | None) -> str:
    found = read_workbook(folder)
    new = handed_out_in(Path(handed_out).resolve(), folder) if handed_out else {}
    language = language or found.language
    print(TEXTS["opened"].say(language, folder=folder))
    if language != found.language or (found.tflab == __version__ and not bring_in):
        before = _pages(folder)
        lay_out(folder, language)  # what is missing
        for page in sorted(_pages(folder) - before) if language == found.language else ():
            print(TEXTS["brought_back"].say(language, page=page))
    if found.edition == "class" and not (folder / "exercises" / language).is_dir():
        print(TEXTS["instructors"].say(language))
    if bring_in:
        _tell(update(folder, new), folder, language)
    elif found.tflab != __version__:
        print(TEXTS["other_version"].say(language, theirs=found.tflab, ours=__version__, folder=folder))
    return language if has_language(folder, language) else found.language


def _pages(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.glob("*/*/*.ipynb")}


def _tell(changes: Sequence[Change], folder: Path, language: str) -> None:
    if not changes:
        print(TEXTS["up_to_date"].say(language, version=__version__))
        return
    for change in changes:
        # change.what is "new", "replaced", "merged" or "kept"
        said = TEXTS[change.what].say(language, kept=change.kept)
        said += TEXTS["beside"].say(language, beside=change.beside) if change.beside else ""
        print(f"  {change.path}: {said}")
    backups = sorted((folder / ".tflab" / "backups").glob("*"), key=lambda path: path.name.zfill(9))
    if backups and any(change.what in ("replaced", "merged") for change in changes):
        print(TEXTS["backup"].say(language, folder=backups[-1]))


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
