"""Every GL name in the code that saves the host's state stands in docs/host-contract.md.

And no other stands in its list. Extensions that the code only looks for may stand in the section on
OpenGL ES instead.

host_contract.py HOST_STATE.C... HOST_CONTRACT.MD
"""

import re
import sys

NUMBERS = {"GL_TRUE", "GL_FALSE"}


def names(text):
    return set(re.findall(r"\bGL_[A-Za-z0-9_]+\b", text)) - NUMBERS


code = set()
for path in sys.argv[1:-1]:
    with open(path, encoding="utf-8") as source:
        code |= names(source.read())
with open(sys.argv[-1], encoding="utf-8") as document:
    text = document.read()
state, es = (
    text.split(f"\n## {title}\n")[1].split("\n## ")[0]
    for title in ("State that is saved and restored", "What OpenGL ES lacks")
)
listed = names(state)
allowed = listed | {name for name in names(es) if name.startswith(("GL_EXT_", "GL_OES_"))}

if len(code) < 50:
    sys.exit(f"only {len(code)} GL names found in {sys.argv[1:-1]}")
if code - allowed or listed - code:
    sys.exit(f"not in the document: {sorted(code - allowed)}; "
             f"not in the code: {sorted(listed - code)}")
print(f"{len(code)} names")
