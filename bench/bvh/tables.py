"""What was measured of the trees, as Markdown tables."""

import math
import re

RAYS = ("primary", "bounce", "shuffled", "occlusion")
SCENES = ("bunny", "ogre", "bumpy_sphere", "city", "room")

# (what it is about, program, raio's tree, its peers: the fastest counts)
AGAINST = (
    ("Embree, default quality", "triangles", "raio", ("embree", "embree_avx2")),
    ("Embree and raio, high quality", "triangles", "raio_high", ("embree_high", "embree_high_avx2")),
    ("Embree, robust mode", "triangles", "raio", ("embree_robust", "embree_robust_avx2")),
    ("Embree for AVX2, raio compiled for AVX2", "triangles_avx2", "raio", ("embree_avx2",)),
    ("Embree, default quality, by quick triangles", "triangles", "quick", ("embree", "embree_avx2")),
    ("tinybvh's BVH8_CPU", "triangles", "raio", ("tinybvh",)),
    ("tinybvh's BVH8_CPU and raio, high quality", "triangles", "raio_high", ("tinybvh_high",)),
    ("tinybvh's BVH8_CPU, by quick triangles", "triangles", "quick", ("tinybvh",)),
    ("its quick triangles in the same nodes", "triangles", "raio", ("quick",)),
)


def medians(results):
    """{(program, *name): the entry}. What Google Benchmark adds to a name is left out."""
    return {(entry["program"], *re.sub(r"/(iterations:\d+|real_time)", "", entry["run_name"]).split("/")): entry
            for entry in results["benchmarks"] if entry.get("aggregate_name", "median") == "median"}


def table(head, rows, words=1):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * words + "---:|" * (len(head) - words)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def millions(measured, *key):
    """Millions of rays, or of triangles, in a second."""
    return measured[key]["items_per_second"] / 1e6 if key in measured else None


def shown(value):
    return "" if value is None else f"{value:.3g}"


def ratio(measured, program, scene, rays, ours, peers):
    fastest = max((millions(measured, program, scene, rays, peer) or 0 for peer in peers), default=0)
    own = millions(measured, program, scene, rays, ours)
    return own / fastest if own and fastest else None


def mean_ratio(measured, program, rays, ours, peers):
    """The geometric mean over the scenes that were measured."""
    ratios = [ratio(measured, program, scene, rays, ours, peers) for scene in SCENES]
    ratios = [r for r in ratios if r]
    return math.exp(sum(map(math.log, ratios)) / len(ratios)) if ratios else None


def names(measured, program, position):
    return list(dict.fromkeys(key[position] for key in measured if key[0] == program))


def summary(measured):
    rows = [[what] + [shown(mean_ratio(measured, program, rays, ours, peers)) for rays in RAYS]
            for what, program, ours, peers in AGAINST]
    return table(["raio's rays per second over those of", *RAYS], [row for row in rows if any(row[1:])])


def per_scene(measured):
    rows = [[scene, what] + [shown(ratio(measured, program, scene, rays, ours, peers)) for rays in RAYS]
            for scene in SCENES for what, program, ours, peers in AGAINST]
    return table(["scene", "over", *RAYS], [row for row in rows if any(row[2:])], words=2)


def rates(measured, program):
    rows = [[scene, f"**{name}**" if name.startswith("raio") else f"`{name}`"]
            + [shown(millions(measured, program, scene, rays, name)) for rays in RAYS]
            for scene in names(measured, program, 1) for name in names(measured, program, 3)]
    return table(["scene", "tree", *RAYS], [row for row in rows if any(row[2:])], words=2)


def packets(measured):
    trees = ("raio", "quick", "embree", "embree_avx2")
    rows = []
    for scene in names(measured, "triangles", 1):
        rates = [millions(measured, "triangles", scene, "packets", tree) for tree in trees]
        own = ratio(measured, "triangles", scene, "packets", "raio", trees[2:])
        alone = millions(measured, "triangles", scene, "primary", "raio")
        if any(rates):
            rows.append([scene, *map(shown, rates), shown(own), shown(rates[0] / alone if rates[0] and alone else None)])
    return table(["scene", *(f"`{tree}`" for tree in trees), "over Embree", "over single rays"], rows)


def other_shapes(measured):
    rows = []
    for scene in names(measured, "shapes", 1):
        peers = [key[3] for key in measured
                 if key[:3] == ("shapes", scene, "primary") and key[3].startswith("embree")]
        rows.append([scene] + [shown(ratio(measured, "shapes", scene, rays, "raio", peers)) for rays in RAYS])
    return table(["scene", *RAYS], rows)


def builds(measured):
    rows = []
    for name in names(measured, "build", 2):
        rates = [millions(measured, "build", threads, name) for threads in ("1", "2")]
        gain = rates[1] / rates[0] if all(rates) else None
        size = measured["build", "1", name]["bytes"] if ("build", "1", name) in measured else None
        rows.append([f"**{name}**" if name.startswith("raio") else f"`{name}`", *map(shown, rates), shown(gain),
                     shown(size)])
    return table(["tree", "1 thread", "2 threads", "gain", "bytes a triangle"], rows)


def weekend(measured):
    numbers = names(measured, "weekend", 2)

    def columns(name):
        """Of each number type, as it is and over the book's list and tree, where these were measured."""
        for number in numbers:
            own = millions(measured, "weekend", "weekend", number, name)
            peers = [millions(measured, "weekend", "weekend", number, peer) for peer in ("list", "bvh")]
            yield from [own] + [own / peer if own and peer else None for peer in peers]

    rows = [[f"**{name}**" if name.startswith("raio") else f"`{name}`", *map(shown, columns(name))]
            for name in names(measured, "weekend", 3)]
    head = [text for number in numbers for text in (f"{number}, Mrays/s", "over `list`", "over `bvh`")]
    return table(["world", *head], rows)


def growth(measured):
    sizes = names(measured, "growth", 1)
    rows = [[what, f"**{name}**" if name.startswith("raio") else f"`{name}`"]
            + [shown(millions(measured, "growth", size, what, name)) for size in sizes]
            for what in ("primary", "bounce", "shuffled", "occlusion", "build")
            for name in names(measured, "growth", 3)]
    return table(["", "tree", *(f"{int(size):,}" for size in sizes)], rows, words=2)


def markdown(results):
    measured = medians(results)
    programs = {key[0] for key in measured}
    context = results["context"]
    parts = [f"{context['num_cpus']} cores at {context['mhz_per_cpu'] / 1000:.1f} GHz, {context['date'][:10]}."]
    if "triangles" in programs:
        parts += ["Triangles, one thread, single rays, geometric means over the scenes, always the faster of Embree's "
                  "instruction sets:", summary(measured),
                  "The same, scene by scene:", per_scene(measured),
                  "Million rays per second:", rates(measured, "triangles"),
                  "Primary rays, 64 at a time (8 x 8 pixels), and 16 (4 x 4) of Embree, million rays per second:", packets(measured)]
    if "triangles_avx2" in programs:
        parts += ["Compiled for AVX2, million rays per second:", rates(measured, "triangles_avx2")]
    if "shapes" in programs:
        parts += ["Other shapes, raio over the best of Embree's:", other_shapes(measured),
                  "Million rays per second:", rates(measured, "shapes")]
    if "build" in programs:
        parts += ["Building, million triangles per second, of a million:", builds(measured)]
    if "growth" in programs:
        parts += ["Million rays, and million triangles built, per second, over the number of triangles:",
                  growth(measured)]
    if "weekend" in programs:
        parts += ["The final scene of *One Weekend*:", weekend(measured)]
    return "\n\n".join(parts) + "\n"
