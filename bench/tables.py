"""The results as Markdown tables."""

NUMBERS = ("float", "double")
PERCENTS = ("0", "50", "100")

OURS = ("hit", "record_hit", "occluded", "quick_hit", "quick_occluded", "hit_in_packs", "occluded_in_packs")

# (row, shape, the textbook that finds as much as `record_hit` and `quick_hit`, percentage of hits): the table at a glance
GLANCE = (("list: one of 488 spheres, 95 % missed", "bouncing_list", "one_weekend", "5"),
          ("sphere", "sphere", "one_weekend", "50"),
          ("triangle", "triangle", "moeller_trumbore_record", "50"),
          ("plane", "plane", "glm_record", "50"),
          ("disc", "disc", "glm_record", "50"),
          ("box", "box", "slabs_record", "50"),
          ("cylinder", "cylinder", "quadratic", "50"),
          ("torus", "torus", "ferrari", "50"))
# The last rows: the worlds that a path tracer is measured with, of the book, quick and exact.
GLANCE_TREE = "tree: a ray of the final scene of *One Weekend*, and its shading"
GLANCE_TREES = ("bvh", "raio_quick", "raio")

# (shape, peer, the peer's number type or None for the shape's own): what `hit` shall be no slower than
BAR = (("sphere", "one_weekend", "double"), ("sphere", "next_week", "double"), ("triangle", "glm", None),
       ("plane", "glm", None))


def medians(results):
    """{(shape, call, number, percent): (nanoseconds per test, does it return a normal?)}"""
    return {tuple(entry["run_name"].split("/")): (entry["test"] * 1e9, entry["record"] > 0)
            for entry in results["benchmarks"]
            if entry.get("aggregate_name", "median") == "median" and "record" in entry}  # others are no shapes


def shown(value):
    """Three digits, and all of a larger number's."""
    return f"{value:.3g}" if value < 999.5 else f"{value:,.0f}"


def calls(measured, shape):
    return list(dict.fromkeys(key[1] for key in measured if key[0] == shape))


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---|---|" + "---:|" * (len(head) - 2)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def cells(measured, shape, call, of=lambda nanoseconds, key: nanoseconds):
    """One cell for each number type and percentage of hits."""
    for number in NUMBERS:
        for percent in PERCENTS:
            key = (shape, call, number, percent)
            yield shown(of(measured[key][0], key)) if key in measured else ""


def machine(results):
    context = results["context"]
    return f"{context['num_cpus']} cores at {context['mhz_per_cpu'] / 1000:.1f} GHz, {context['date'][:10]}."


def glance_times(results, trees):
    """[(what, number, nanoseconds of a textbook, of quick and exact with the same record, of the whole record, of exact
    packs, or None)]"""
    measured = medians(results)
    rows = []
    for name, shape, peer, percent in GLANCE:
        for number in NUMBERS:
            contenders = (peer, "quick_hit", "record_hit", "hit", "hit_in_packs")
            times = [measured.get((shape, call, number, percent)) for call in contenders]
            if times[0]:
                rows.append((name, number, *(time[0] if time else None for time in times)))
    rates = {entry["run_name"].split("/iterations")[0]: entry["items_per_second"] for entry in trees["benchmarks"]
             if entry.get("aggregate_name", "median") == "median" and entry["program"] == "weekend"}
    for number in NUMBERS:
        times = [rates.get(f"weekend/{number}/{world}") for world in GLANCE_TREES]
        if times[0]:
            rows.append((GLANCE_TREE, number, *(1e9 / time if time else None for time in times), None, None))
    return rows


def glance(results, trees):
    """What a reader wants to know first."""
    def cell(value):
        return "" if value is None else shown(value)

    rows = []
    for name, number, textbook, *ours in glance_times(results, trees):
        ratios = [time / textbook if time else None for time in ours[:2]]
        rows.append([name, number] + [cell(value) for value in (textbook, *ours, *ratios)])
    head = ["nanoseconds", "number", "textbook", "`quick`", "exact", "exact, with uv and error", "the same in packs",
            "`quick` / textbook", "exact / textbook"]
    return machine(results) + "\n\n" + table(head, rows) + "\n"


def short_glance(results, trees):
    """The same for who has not decided yet: a line for each, float and double side by side."""
    times = {(name, number): " / ".join(shown(value) if value else "-" for value in values)
             for name, number, *values in glance_times(results, trees)}
    rows = [[name] + [times.get((name, number), "") for number in NUMBERS]
            for name in dict.fromkeys(name for name, number in times)]
    lines = ["| nanoseconds: textbook / quick / exact / exact with uv and error / the same in packs | float | double |",
             "|---|---:|---:|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def markdown(results):
    measured = {key: value for key, value in medians(results).items() if key[3] in PERCENTS}
    shapes = list(dict.fromkeys(key[0] for key in measured))
    columns = [f"{number} {percent} %" for number in NUMBERS for percent in PERCENTS]

    def ratio_to(peer, peer_number=None):
        return lambda ns, key: ns / measured[key[0], peer, peer_number or key[2], key[3]][0]

    def bar(call):
        return [[shape, f"`{peer}`" + (f" in {number}" if number else "")]
                + list(cells(measured, shape, call, ratio_to(peer, number)))
                for shape, peer, number in BAR if shape in shapes]

    def in_packs():
        """Of floats, what one call and one lane cost; and what the first peer does."""
        ours = ("hit", "hit_in_packs", "occluded", "occluded_in_packs")
        for shape in shapes:
            if "hit_in_packs" in calls(measured, shape):
                peers = [(peer, number or "float") for of, peer, number in BAR if of == shape]
                peers += [(call, "float") for call in calls(measured, shape) if call not in OURS]
                contenders = [(call, "float") for call in ours] + peers[:1]
                costs = [" / ".join(shown(measured[shape, call, number, percent][0]) for percent in PERCENTS)
                         for call, number in contenders]
                if peers:
                    costs[-1] += f" (`{peers[0][0]}`" + (f" in {peers[0][1]})" if peers[0][1] != "float" else ")")
                yield [shape] + costs + [""] * (len(ours) + 1 - len(costs))

    ratios, times = [], []
    for shape in shapes:
        for call in calls(measured, shape):
            returns_normal = measured[shape, call, "float", "50"][1]
            name = f"**{call}**" if call in OURS else f"`{call}`"
            times.append([shape, name] + list(cells(measured, shape, call)))
            if call in OURS:
                continue
            for ours in (("hit", "record_hit", "quick_hit") if returns_normal else ("occluded", "quick_occluded")):
                if ours in calls(measured, shape):
                    ratios.append([shape, f"{ours} / `{call}`"] + list(cells(measured, shape, ours, ratio_to(call))))
    rate = [[shape, "**hit**"] + list(cells(measured, shape, "hit", lambda ns, key: 1e3 / ns)) for shape in shapes]

    return "\n\n".join([
        machine(results),
        "`hit`, with its record filled, over the peers that it shall not be slower than:",
        table(["shape", "peer"] + columns, bar("hit")),
        "The same in packs, as many tests at a time as registers have lanes (`hit_in_packs`), over the same peers:",
        table(["shape", "peer"] + columns, bar("hit_in_packs")),
        "Packs of floats beside one call at a time, nanoseconds per test at 0, 50 and 100 % hits:",
        table(["shape", "`hit`", "`hit_in_packs`", "`occluded`", "`occluded_in_packs`", "peer"], in_packs()),
        "`hit`, `record_hit` and `quick_hit` over the peers that find a normal, `occluded` and `quick_occluded` over those that do not:",
        table(["shape", "ratio"] + columns, ratios),
        "Nanoseconds per test:",
        table(["shape", "call"] + columns, times),
        "Million rays per second:",
        table(["shape", "call"] + columns, rate)]) + "\n"


def update(readme, what, text):
    """Puts the text into a README between the lines that say who writes there."""
    start, end = f"<!-- {what} writes from here -->\n", "<!-- to here -->\n"
    before, rest = readme.read_text().split(start)
    old, after = rest.split(end, 1)
    readme.write_text(before + start + "\n" + text + "\n" + end + after)
