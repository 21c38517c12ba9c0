"""Why can a file not be graded, or not as it is?  Each reason once, in both languages.

    Unreadable("no JSON", line=3)    03.ipynb: not a notebook: no valid JSON, line 3.
                                     03.ipynb: 노트북이 아닙니다. 3번째 줄이 올바른 JSON이 아닙니다.

They are kinds of remarks, and stand inside another one that names the file.  What an
operating system or Python says of a fault is in English everywhere.
"""

from __future__ import annotations

from tflab.text import Text

__all__ = ["REASONS"]

REASONS = {
    # files
    "nowhere": Text(
        en="there is no {place}; name a folder, a zip or a notebook",
        ko="없는 곳입니다: {place}. 폴더나 zip 파일, 노트북을 지정하십시오",
    ),
    "link": Text(en="a link to another file, not a file", ko="파일이 아니라 다른 파일을 가리키는 링크입니다"),
    "no file there": Text(en="not a regular file", ko="일반 파일이 아닙니다"),
    "closed": Text(en="cannot be opened ({error})", ko="열 수 없습니다({error})"),
    "not read": Text(en="cannot be read ({error})", ko="읽을 수 없습니다({error})"),
    "too large": Text(
        en="{size} MB, more than {most} MB: clear the outputs and hand it in again",
        ko="{size} MB로 한도 {most} MB를 넘습니다. 출력을 지우고 다시 제출하십시오",
    ),
    "too much": Text(en="more than {most} MB were handed in", ko="제출한 파일이 모두 합해 {most} MB를 넘습니다"),
    "linked folder": Text(
        en="a link to another folder; left out",
        ko="다른 폴더를 가리키는 링크라서 뺐습니다",
    ),
    "and more": Text(en="{names} and {count} more", ko="{names} 외 {count}개"),
    # zips
    "no zip": Text(en="not a zip file that can be read ({error})", ko="읽을 수 있는 zip 파일이 아닙니다({error})"),
    "pipe": Text(en="a link, a pipe or a device, not a file", ko="파일이 아니라 링크나 파이프, 장치입니다"),
    "many files": Text(en="{count} files in it, more than {most}", ko="파일이 {count}개로 한도 {most}개를 넘습니다"),
    "more like these": Text(en="{count} more like these", ko="이와 같은 것이 {count}개 더 있습니다"),
    "many names": Text(
        en="the list of its files is longer than {most} files have",
        ko="파일 목록이 {most}개 분량을 넘습니다",
    ),
    "many zips": Text(
        en="more than {most} zips in a zip, or more than {megabytes} MB of them: hand in the notebooks themselves",
        ko="zip 안의 zip이 {most}개, 모두 합해 {megabytes} MB를 넘습니다. 노트북 파일을 그대로 제출하십시오",
    ),
    "deep zip": Text(
        en="a zip in a zip in a zip, not opened: hand in the notebooks themselves",
        ko="zip 안의 zip 안에 또 zip이 있어 열지 않았습니다. 노트북 파일을 그대로 제출하십시오",
    ),
    "leads out": Text(
        en="it leads out of the archive; refused",
        ko="압축 파일 밖을 가리키는 이름이라서 받지 않았습니다",
    ),
    "link in a zip": Text(
        en="a link to another file; refused",
        ko="다른 파일을 가리키는 링크라서 받지 않았습니다",
    ),
    "locked": Text(en="it is locked with a password; refused", ko="암호가 걸려 있어서 받지 않았습니다"),
    "damaged": Text(en="damaged in the archive ({error})", ko="압축 파일 안에서 손상되었습니다({error})"),
    # notebooks
    "empty file": Text(en="an empty file", ko="빈 파일입니다"),
    "zip": Text(
        en="a zip file, not a notebook: unpack it, or hand over the zip itself",
        ko="노트북이 아니라 zip 파일입니다. 압축을 풀어 제출하거나 이름을 .zip으로 되돌려 제출하십시오",
    ),
    "no JSON": Text(
        en="not a notebook: no valid JSON, line {line}",
        ko="노트북이 아닙니다. {line}번째 줄이 올바른 JSON이 아닙니다",
    ),
    "too deep": Text(
        en="not a notebook: its lists are nested too deep",
        ko="노트북이 아닙니다. 리스트가 너무 깊이 겹쳐 있습니다",
    ),
    "many lists": Text(
        en="not a notebook: millions of lists in it",
        ko="노트북이 아닙니다. 리스트가 수백만 개 들어 있습니다",
    ),
    "no cells": Text(en="not a notebook: no cells in it", ko="노트북이 아닙니다. 셀이 없습니다"),
    "many cells": Text(en="{count} cells, more than {most}", ko="셀이 {count}개로 한도 {most}개를 넘습니다"),
    "no chapter": Text(
        en="none of its cells belongs to a chapter with exercises; in {root} there is {there}",
        ko="연습 문제가 있는 장의 셀이 하나도 없습니다. {root}에 있는 장: {there}",
    ),
    "endless to read": Text(
        en="to read it took more than {seconds} s of computing or {most} MB of memory: "
        "clear the outputs and hand it in again",
        ko="읽는 데 계산 {seconds}초나 메모리 {most} MB가 넘게 듭니다. 출력을 지우고 다시 제출하십시오",
    ),
    # notebooks that can be read
    "encoding": Text(
        en="it is written in {encoding}, not in UTF-8",
        ko="UTF-8이 아닌 인코딩({encoding})으로 저장되어 있습니다",
    ),
    "letters": Text(
        en="some of its letters are in no known encoding",
        ko="어느 인코딩으로도 읽을 수 없는 글자가 있습니다",
    ),
    "no cell": Text(
        en="{count} of its cells are no cells, and are left out",
        ko="셀의 형식이 아닌 것이 {count}개 있어서 뺐습니다",
    ),
}
