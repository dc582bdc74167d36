"""What the library promises to cost, and whether the figures of a report keep it."""

import os

# SIZE is for whoever tries script/bench with something small.
SIZE_PX, LENS, FOV_DEG = int(os.environ.get("SIZE", "1024")), "angular", 140


def by_name(comparison):
    return {one["name"]: one for one in comparison["contenders"] if one["took_part"]}


def ratio(comparison, name):
    found = by_name(comparison)
    return found[name]["ratio"] if name in found else None


def median_ms(comparison, name):
    found = by_name(comparison)
    return found[name]["time_ms"][1] if name in found else None


def blits_beyond(comparison, name, factor=1.08):
    """What a frame takes beyond so many perspective views, in blits."""
    times = [median_ms(comparison, one) for one in (name, "perspective", "blit")]
    return None if None in times else (times[0] - factor * times[1]) / times[2]


def times_as_fast(comparison, name):
    """How many times as long a contender takes as Cupola."""
    other, own = median_ms(comparison, name), median_ms(comparison, "cupola")
    return None if other is None or own is None else other / own


def eye_adds(comparison):
    """What an eye that moves adds to a frame, warp and masks, in warps of one that rests."""
    table = comparison["table"]
    names = (table, f"{table}-moving", "clear", "clear-moving")
    times = [median_ms(comparison, one) for one in names]
    return None if None in times else (times[1] - times[0] + times[3] - times[2]) / times[0]


def fact(comparison, name, key):
    found = by_name(comparison)
    return found[name].get(key) if name in found else None


def bytes_in_all(comparison, name):
    """Colour, depth and tables, per byte of the output."""
    parts = [fact(comparison, name, key)
             for key in ("bytes_per_output_byte", "table_bytes_per_output_byte")]
    return None if None in parts else sum(parts)


def of(family, load=None, off_axis=False):
    """Which comparisons count: those at the size and lens that bars are stated for."""
    def counts(one):
        return (one["family"] == family and one["size_px"] == SIZE_PX and one["lens"] == LENS
                and one["fov_deg"] == FOV_DEG and one["off_axis"] == off_axis
                and (load is None or one["load"] in load))
    return counts


def of_table(suffix=""):
    return lambda one: ratio(one, one["table"] + suffix)


FILL_BOUND = ("ns:100", "heavy")
ROOM = ("light", "lambert", "heavy", "ns:25", "ns:40", "ns:100")
FOREST = ("forest", "forest:1000000")
AT_MOST, AT_LEAST = "at most", "at least"
BARS = [
    *[(f"dome / perspective at {cost} ns a pixel", AT_MOST, bar, of("frame", (f"ns:{cost}",)),
       lambda one: ratio(one, "cupola")) for cost, bar in ((100, 1.10), (40, 1.18), (25, 1.30))],
    ("at any load of the room, beyond 1.08 perspective: blits", AT_MOST, 2, of("frame", ROOM),
     lambda one: blits_beyond(one, "cupola")),
    *[(f"texels shaded per output pixel, {words}", AT_MOST, bar, of("frame"),
       lambda one, name=name: fact(one, name, "shaded_texels_per_pixel"))
      for words, name, bar in (("three views", "cupola-3-views", 1.61),
                               ("five", "cupola-5-views", 1.36),
                               ("any number", "cupola", 1.22))],
    ("warp on axis, at rest: blits", AT_MOST, 1.2, of("warp"), of_table()),
    ("warp off axis: blits", AT_MOST, 1.5, of("warp", off_axis=True), of_table()),
    ("warp of an eye that moved: blits", AT_MOST, 1.5, of("eye", off_axis=True),
     of_table("-moved")),
    ("four full faces / dome, fill-bound", AT_LEAST, 3, of("frame", FILL_BOUND),
     lambda one: times_as_fast(one, "four-faces")),
    ("six full faces / dome, fill-bound", AT_LEAST, 4, of("frame", FILL_BOUND),
     lambda one: times_as_fast(one, "six-faces")),
    *[(f"forest of a million triangles, dome planned for {words} / perspective", AT_MOST, 1.2,
       of("frame", FOREST), lambda one, name=name: ratio(one, name))
      for words, name in (("vertices", "cupola-vertices"), ("texels", "cupola"))],
    ("forest, beyond 1.08 perspective: blits", AT_MOST, 2, of("frame", FOREST),
     lambda one: blits_beyond(one, "cupola")),
    ("an eye that moves adds: warps", AT_MOST, 1, of("eye", off_axis=True), eye_adds),
    ("bytes of colour, depth and baked warp / output", AT_MOST, 3.5, of("frame"),
     lambda one: bytes_in_all(one, "cupola")),
]


def place(comparison):
    plain = by_name(comparison).get("perspective")
    text = f"load {comparison['load']}" if plain else f"table {comparison['table']}"
    if plain and "cupola" in by_name(comparison):
        text += f", {by_name(comparison)['cupola']['note'].split(',')[0]}"
    if comparison.get("object_radius_deg"):
        text += f", trees of {comparison['object_radius_deg']:.1f}° radius (median)"
    if plain:
        text += f", {plain['ns_per_pixel']:.1f} ns a pixel"
    return f"{text}, {frames_of(comparison)}"


def frames_of(comparison):
    return f"{comparison['frames']:.0f} frame{'s' if comparison['frames'] > 1 else ''}"


def bar_row(bar, comparisons):
    """The worst of what was measured."""
    words, sense, limit, counts, measure = bar
    found = [(measure(one), one) for one in comparisons if counts(one)]
    found = [(value, one) for value, one in found if value is not None]
    if not found:
        return f"| {words} | {sense} {limit:g} | – | not measured | |"
    worst = (max if sense == AT_MOST else min)(found, key=lambda pair: pair[0])
    met = worst[0] <= limit if sense == AT_MOST else worst[0] >= limit
    return (f"| {words} | {sense} {limit:g} | {worst[0]:.2f} | {'yes' if met else '**no**'} "
            f"| {place(worst[1])} |")


def bar_lines(comparisons):
    rows = [bar_row(bar, comparisons) for bar in BARS]
    if not any(of(family)(one) or of(family, off_axis=True)(one) for one in comparisons
               for family in ("frame", "warp", "eye")):
        return []
    return [f"## What is promised: {SIZE_PX} px, {LENS} {FOV_DEG}°, no loss", "",
            "Guard bands have 2 texels. Each figure is the worst of what was measured below. "
            "Texels are those that an occlusion query counts, bytes those of the GL's objects.", "",
            "| what | promised | measured | kept | where |", "|---|---|---|---|---|", *rows, ""]


def memory_lines(comparisons):
    """What each table stage keeps, from the first comparison of warps."""
    found = [one for one in comparisons if of("warp")(one)][:1]
    rows = []
    for name, stage in by_name(found[0]).items() if found else ():
        if stage.get("table_bytes_per_output_byte") is not None:
            rows.append(f"| {name} | {stage['bytes_per_output_byte']:.2f} "
                        f"| {stage['table_bytes_per_output_byte']:.2f} "
                        f"| {bytes_in_all(found[0], name):.2f} |")
    if not rows:
        return []
    return ["## Memory by table stage", "",
            f"In bytes of the output as RGBA8, {SIZE_PX} px, {LENS} {FOV_DEG}°. The table is all "
            "that is kept for the warp: pixels' numbers, or tiles; the mask's triangles are in it.",
            "", "| table stage | views: colour and depth | table | in all |", "|---|---|---|---|",
            *rows, ""]
