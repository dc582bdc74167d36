"""Every GL name in lib/gl/host_state.c stands in the list of docs/host-contract.md, and no other.

host_contract.py HOST_STATE.C HOST_CONTRACT.MD
"""

import re
import sys

NUMBERS = {"GL_TRUE", "GL_FALSE"}


def names(text):
    return set(re.findall(r"\bGL_[A-Za-z0-9_]+\b", text)) - NUMBERS


with open(sys.argv[1], encoding="utf-8") as source:
    code = names(source.read())
with open(sys.argv[2], encoding="utf-8") as document:
    section = document.read().split("## State that is saved and restored")[1].split("\n## ")[0]
listed = names(section)

if len(code) < 50:
    sys.exit(f"only {len(code)} GL names found in {sys.argv[1]}")
if code != listed:
    sys.exit(f"not in the document: {sorted(code - listed)}; not in the code: {sorted(listed - code)}")
print(f"{len(code)} names")
