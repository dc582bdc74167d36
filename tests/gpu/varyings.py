"""What tiles hand from vertex to fragment shader fits into what every context has.

That is 15 vectors in OpenGL ES 3.0 (GL_MAX_VARYING_VECTORS), 60 numbers in OpenGL 3.3. For each
kind of tile, with what asks for the output's corner (a gain, noise, turned patterns) and without,
with cones and without; and both shaders declare the same.

varyings.py VERTEX_SHADER FRAGMENT_SHADER EXACT_FRAGMENT_SHADER COMPILER...
"""

import re
import subprocess
import sys

KINDS = ["PURE", "PAIR", "CHOOSING", "EXACT", "DARK"]
LEAST = 15
# Locations of a type: a matrix has one for each column.
SIZES = {"float": 1, "vec2": 1, "vec3": 1, "vec4": 1, "mat3": 3, "mat3x4": 3}


def varyings(compiler, text, way, kind, corner, metric):
    """Types by name, of what is left of a shader's text by its conditions."""
    defines = [f"-DTILE_{name}={number}" for number, name in enumerate(KINDS)]
    defines += [f"-DTILE_KIND=TILE_{kind}", f"-DCORNER={corner}", f"-DMETRIC={metric}",
                "-DSTAGE=1", "-DSTAGE_NONE=1", "-DRAYS=1"]
    run = subprocess.run(compiler + ["-E", "-P", "-x", "c", *defines, "-"], input=text, text=True,
                         stdout=subprocess.PIPE, check=True)
    found = re.findall(rf"\bflat {way} (\w+) (\w+)(?:\[(\d+)\])?;", run.stdout)
    if len(found) != len(re.findall(rf"^(?!layout)[^(\n]*\b{way} ", run.stdout, re.M)):
        sys.exit(f"{kind} tiles: an `{way}` that this program does not understand")
    return {name: (kind_of, int(count or 1)) for kind_of, name, count in found}


def vectors(found):
    return sum(SIZES[kind] * count for kind, count in found.values())


vertex, fragment, exact = (open(path, encoding="utf-8").read() for path in sys.argv[1:4])
compiler = sys.argv[4:]
most = 0
for kind in KINDS:
    for corner, metric in ((0, 0), (1, 0), (0, 1), (1, 1)):
        out = varyings(compiler, vertex, "out", kind, corner, metric)
        into = varyings(compiler, exact if kind == "EXACT" else fragment, "in", kind, corner,
                        metric)
        if out != into:
            sys.exit(f"{kind} tiles, corner {corner}, metric {metric}: {out} is not {into}")
        print(f"{kind} tiles, corner {corner}, metric {metric}: {vectors(out)} of {LEAST} vectors")
        most = max(most, vectors(out))
if most > LEAST:
    sys.exit(f"{most} vectors; allowed: {LEAST}")
# The control: what this is for had one more.
more = vertex.replace("flat out vec3 lead;", "flat out vec3 lead;\nflat out vec2 corner_too;")
if vectors(varyings(compiler, more, "out", "PAIR", 1, 1)) != most + 1:
    sys.exit("one vector more is not seen")
