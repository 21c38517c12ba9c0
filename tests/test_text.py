"""Texts in two languages: what a file of texts may hold, and that each text of the package is used."""

from __future__ import annotations

import string
from pathlib import Path

import pytest

import tflab
from tflab.text import Text, TextError, Texts

ROOT = Path(tflab.__file__).parent
MODULES = [path for path in sorted(ROOT.rglob("*.py")) if "= Texts(__file__)\n" in path.read_text(encoding="utf-8")]


def texts_of(folder: Path, content: str) -> Texts:
    (folder / "replies.yaml").write_text(content, encoding="utf-8")
    return Texts(str(folder / "replies.py"))


def test_a_file_of_texts_is_read_by_key(tmp_path):
    texts = texts_of(tmp_path, "empty:\n  en: Not answered yet.\n  ko: 아직 답하지 않았습니다.\n")
    assert dict(texts) == {"empty": Text("Not answered yet.", "아직 답하지 않았습니다.")}


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("a:\n  en: One.\n", "line 2: a text has `en` and `ko`, and nothing else"),
        ("a:\n  en: One.\n  ko: ''\n", "line 2: `ko` is empty"),
        ("a: One.\n", "line 1: a text has `en` and `ko`, and nothing else"),
        ("a: {en: One., ko: 하나.}\na: {en: Two., ko: 둘.}\n", 'line 2: "a" is there twice'),
        ("- a\n", "line 1: a mapping is expected"),
        ("a: [\n", "line 2: did not find expected node content"),
    ],
)
def test_a_faulty_file_is_refused_with_its_line(tmp_path, content, message):
    with pytest.raises(TextError, match=r"^replies\.yaml, ") as refused:
        dict(texts_of(tmp_path, content))
    assert message in str(refused.value)


@pytest.mark.parametrize("module", MODULES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_texts_of_a_module_are_all_used_and_name_the_same_in_both_languages(module):
    template = module.with_suffix(".jinja")
    readers = [module, *module.parent.glob("templates/*.html"), *([template] if template.exists() else [])]
    source = "".join(reader.read_text(encoding="utf-8") for reader in readers)
    for key, text in Texts(str(module)).items():
        ways = f'"{key}"', f"label.{key}", f'"{key.rpartition("_")[0]}_"'  # the last with a word that is put behind it
        assert "TEXTS = " not in source or any(way in source for way in ways), f"{key} is never read"
        named = [{name for _, name, _, _ in string.Formatter().parse(part) if name} for part in text]
        assert named[0] == named[1], key
