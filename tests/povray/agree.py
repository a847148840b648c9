"""agree.py RENDERER POVRAY FOLDER: does an independent renderer see the same as raio-render?

Every scene is written twice from one description, for raio-render and for POV-Ray, and rendered by both. A pixel's
grey is the depth of what is seen there, black is nothing. The pictures may differ in one pixel of a thousand, and only
where a silhouette or an edge passes. Exits with 77, which is a skipped test, where there is no POV-Ray.
"""

import math
import pathlib
import shutil
import subprocess
import sys

WIDTH, HEIGHT, FIELD_OF_VIEW = 320, 240, 40.0
EYE, LOOK_AT, UP = (3.0, 4.0, 8.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)
NEAR, FAR = 5.0, 14.0  # the depths that are dark grey and white
DARK = 64  # the level of that grey
TOLERANCE = 3  # of 255 levels: two roundings and the steps of the ramp


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(a, factor):
    return tuple(x * factor for x in a)


def plus(*vectors):
    return tuple(sum(xs) for xs in zip(*vectors))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normalized(a):
    return times(a, 1 / math.sqrt(dot(a, a)))


def words(*vectors):
    """Numbers as the scene format has them."""
    return " ".join(f"{x:.17g}" for v in vectors for x in (v if isinstance(v, tuple) else (v,)))


def pov(vector):
    """A vector as POV-Ray has it."""
    return "<" + ", ".join(f"{x:.17g}" for x in vector) + ">"


# One shape: its words in both languages.


def sphere(center, radius):
    return f"sphere {words(center, radius)}", f"sphere {{ {pov(center)}, {radius} }}"


def box(low, high):
    return f"box {words(low, high)}", f"box {{ {pov(low)}, {pov(high)} }}"


def cylinder(base, top, radius, is_open=False):
    axis = minus(top, base)
    size = math.sqrt(dot(axis, axis))
    name, ending = ("open_cylinder", " open") if is_open else ("cylinder", "")
    return (f"{name} {words(base, axis, radius, size)}", f"cylinder {{ {pov(base)}, {pov(top)}, {radius}{ending} }}")


def ring(center, normal, inner, outer):
    return (f"ring {words(center, normal, inner, outer)}",
            f"disc {{ {pov(center)}, {pov(normal)}, {outer}, {inner} }}")


def triangle(a, b, c):
    return f"triangle {words(a, b, c)}", f"triangle {{ {pov(a)}, {pov(b)}, {pov(c)} }}"


def torus(center, major, minor):
    """About the y axis, which is the one that POV-Ray has."""
    return (f"torus {words(center, (0.0, 1.0, 0.0), major, minor)}",
            f"torus {{ {major}, {minor} sturm translate {pov(center)} }}")


def polyhedron(planes):
    return (f"polyhedron {len(planes)} " + " ".join(words(*plane) for plane in planes),
            "intersection { " + " ".join(f"plane {{ {pov(normal)}, {-offset / math.sqrt(dot(normal, normal))} }}"
                                         for normal, offset in planes) + " }")


def capsule(base, top, radius):
    return (f"capsule {words(base, top, radius)}",
            f"sphere_sweep {{ linear_spline 2, {pov(base)}, {radius}, {pov(top)}, {radius} }}")


def surface_of_revolution(profile):
    """About the y axis; the profile of (radius, height)."""
    return (f"surface_of_revolution 0 0 0 0 1 0 {len(profile)} {words(*profile)}",
            f"lathe {{ linear_spline {len(profile)}, {', '.join(pov(point) for point in profile)} sturm }}")


def curved_surface_of_revolution(profile):
    """The same of Bezier segments, each of which begins where the last one ended; POV-Ray has that point twice."""
    points = [profile[i + k] for i in range(0, len(profile) - 1, 3) for k in range(4)]
    return (f"curved_surface_of_revolution 0 0 0 0 1 0 {len(profile)} {words(*profile)}",
            f"lathe {{ bezier_spline {len(points)}, {', '.join(pov(point) for point in points)} sturm }}")


def bezier_curve(controls, radii):
    """POV-Ray's cubic splines go from the second point to the third, at half of the difference of their neighbours."""
    balls = [center + (radius,) for center, radius in zip(controls, radii)]
    first, last = balls[0], balls[3]
    before = plus(last, times(minus(balls[1], first), -6.0))
    after = plus(first, times(minus(last, balls[2]), 6.0))
    return (f"bezier_curve {words(*controls, *radii)}",
            "sphere_sweep { cubic_spline 4, " +
            ", ".join(f"{pov(ball[:3])}, {ball[3]:.17g}" for ball in (before, first, last, after)) + " }")


def blob(threshold, components):
    """Of (center, radius, strength), and of (center, other center, radius, strength)."""
    ours, theirs = [], []
    for *centers, radius, strength in components:
        name, povray_name = ("", "sphere") if len(centers) == 1 else ("capsule ", "cylinder")
        ours.append(f"{name}{words(*centers, radius, strength)}")
        theirs.append(f"{povray_name} {{ {', '.join(pov(c) for c in centers)}, {radius}, {strength} }}")
    return (f"blob {words(threshold)} {len(components)} {' '.join(ours)}",
            f"blob {{ threshold {threshold} {' '.join(theirs)} sturm }}")


def cone(base, apex, radius, is_open=False):
    name, ending = ("open_cone", " open") if is_open else ("cone", "")
    return f"{name} {words(base, apex, radius)}", f"cone {{ {pov(base)}, {radius}, {pov(apex)}, 0{ending} }}"


def frustum(base, top, low, high):
    return f"frustum {words(base, top, low, high)}", f"cone {{ {pov(base)}, {low}, {pov(top)}, {high} }}"


def quadric(low, high, squares, products, linear, constant):
    """Within a box; POV-Ray has the products in another order."""
    yz, zx, xy = products
    return (f"quadric {words(low, high, squares, products, linear, constant)}",
            f"intersection {{ quadric {{ {pov(squares)}, {pov((xy, zx, yz))}, {pov(linear)}, {constant} }} "
            f"box {{ {pov(low)}, {pov(high)} }} }}")


def algebraic(low, high, degree, terms):
    """Within a box; the terms as a map from powers to coefficients. POV-Ray has a coefficient for all there could be."""
    coefficients = [terms.get((i, j, k), 0.0) for i in range(degree, -1, -1) for j in range(degree - i, -1, -1)
                    for k in range(degree - i - j, -1, -1)]
    return (f"algebraic {words(low, high)} {len(terms)} " +
            " ".join(f"{words(c)} {i} {j} {k}" for (i, j, k), c in terms.items()),
            f"intersection {{ poly {{ {degree}, {pov(coefficients)} sturm }} box {{ {pov(low)}, {pov(high)} }} }}")


# Shapes made of shapes.


def combined(operation, povray_operation, parts):
    return (f"{operation} {len(parts)} " + " ".join(part[0] for part in parts),
            f"{povray_operation} {{ " + " ".join(part[1] for part in parts) + " }")


def union(*parts):
    return combined("union", "union", parts)


def intersection(*parts):
    return combined("intersection", "intersection", parts)


def difference(*parts):
    return combined("difference", "difference", parts)


def moved(offset, shape):
    return f"translate {words(offset)} {shape[0]}", f"object {{ {shape[1]} translate {pov(offset)} }}"


def scaled(factors, shape):
    return f"scale {words(factors)} {shape[0]}", f"object {{ {shape[1]} scale {pov(factors)} }}"


X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)

SCENES = {
    "spheres": [sphere((0.0, 0.0, 0.0), 1.0), sphere((1.0, 0.5, -1.0), 1.2), sphere((-1.5, 0.2, 1.0), 0.3)],
    "flat": [ring((-1.2, 0.0, 0.0), (1.0, 2.0, 1.0), 0.4, 1.2), triangle((0.0, -1.0, 0.5), (2.5, -1.0, -1.0), (1.0, 1.5, 0.0)),
             ring((0.5, 0.0, -2.0), Z, 0.0, 1.5)],
    "torus": [torus((0.0, 0.0, 0.0), 1.5, 0.5), torus((0.3, 0.8, 0.2), 0.8, 0.05), torus((-1.2, -1.0, 1.0), 0.5, 0.5)],
    "cylinders": [cylinder((-1.5, -1.0, 0.0), (-1.0, 1.0, 0.5), 0.6), cylinder((1.0, -1.0, 0.0), (1.5, 1.0, -1.0), 0.8, True),
                  capsule((0.0, -0.5, 2.0), (0.5, 1.0, 1.0), 0.3)],
    "polyhedra": [polyhedron([((1.0, 1.0, 1.0), -1.5), ((-1.0, 1.0, 1.0), -1.5), ((1.0, -1.0, 1.0), -1.5),
                              ((1.0, 1.0, -1.0), -1.5), (times(X, -1.0), -1.2), (times(Y, -1.0), -0.9),
                              (times(Z, -1.0), -1.0)]),
                  box((1.5, -1.0, -2.0), (2.5, 1.0, -1.0))],
    "cones": [cone((-1.5, -1.0, 0.0), (-1.0, 1.5, 0.5), 0.8), cone((0.5, 1.0, 1.0), (0.5, -0.8, 0.5), 0.6, True),
              frustum((1.0, -1.0, -1.0), (2.0, 1.0, -1.0), 0.9, 0.4)],
    "quadrics": [quadric((-2.6, -1.0, -1.0), (-0.6, 1.0, 1.0), (1.0, -1.0, 1.0), (0.3, 0.0, 0.0), (3.2, 0.0, 0.0), 2.4),
                 quadric((0.2, -1.0, -1.0), (2.2, 1.0, 1.0), (1.0, 0.0, -1.0), (0.0, 0.0, 0.5), (-2.4, 1.0, 0.0), 1.4)],
    "quartics": [algebraic((-1.2, -1.2, -1.2), (1.2, 1.2, 1.2), 4,
                           {(4, 0, 0): 1.0, (0, 4, 0): 1.0, (0, 0, 4): 1.0, (2, 0, 0): -1.0, (0, 2, 0): -1.0,
                            (0, 0, 2): -1.0, (1, 1, 1): 0.4, (0, 0, 0): 0.35})],
    "turned": [surface_of_revolution([(0.0, -1.0), (0.9, -1.0), (0.9, -0.9), (0.2, -0.7), (0.15, 0.0), (0.8, 0.6),
                                      (1.0, 1.5), (0.9, 1.5), (0.7, 0.7), (0.0, 0.1)])],
    "curves": [curved_surface_of_revolution([(0.0, -1.5), (0.6, -1.5), (0.9, -1.2), (0.9, -0.6), (0.9, 0.2), (0.2, 0.2),
                                             (0.3, 0.9), (0.35, 1.2), (0.6, 1.3), (0.7, 1.4)]),
               bezier_curve([(1.2, -1.0, 0.5), (3.0, -1.0, 0.0), (0.8, 1.5, -1.0), (2.4, 1.4, 0.0)], (0.3, 0.3, 0.2, 0.1)),
               bezier_curve([(-2.5, -1.0, 0.0), (-0.5, -1.0, 0.0), (-2.5, 1.5, 0.0), (-0.8, 1.5, 0.0)], (0.1,) * 4)],
    "blobs": [blob(0.5, [((-1.2, 0.0, 0.0), 1.0, 1.0), ((-0.4, 0.3, 0.3), 1.0, 1.0), ((-0.8, 0.0, 1.0), 0.7, -1.0)]),
              blob(0.4, [((0.8, -1.0, 0.0), (1.4, 1.0, -0.5), 0.7, 1.0), ((1.2, 0.0, 0.4), (2.4, 0.2, 0.0), 0.6, 1.5),
                         ((1.1, 0.0, 0.8), 0.5, -2.0)])],
    "csg": [difference(intersection(box((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0)), sphere((0.0, 0.0, 0.0), 1.35)),
                       cylinder(times(X, -2.0), times(X, 2.0), 0.6), cylinder(times(Y, -2.0), times(Y, 2.0), 0.6),
                       cylinder(times(Z, -2.0), times(Z, 2.0), 0.6)),
            moved((1.8, 0.0, -1.5), union(torus((0.0, 0.0, 0.0), 0.8, 0.3), sphere((0.0, 0.2, 0.0), 0.5))),
            moved((-2.0, 0.5, 0.0), intersection(sphere((0.0, 0.0, -0.5), 0.9), sphere((0.0, 0.0, 0.5), 0.9)))],
    "scaled": [scaled((2.0, 0.5, 1.0), sphere((0.0, 0.0, 0.0), 1.0)),
               moved((0.0, 1.2, 0.0), scaled((1.0, 0.3, -1.5), torus((0.0, 0.0, 0.0), 0.8, 0.3)))],
}


class Camera:
    """Both cameras' rays, which go through the corner of a pixel in raio-render and through its middle in POV-Ray."""

    def __init__(self):
        self.back = normalized(minus(EYE, LOOK_AT))
        self.side = normalized(cross(UP, self.back))
        self.up = cross(self.back, self.side)
        self.height = 2 * math.tan(math.radians(FIELD_OF_VIEW) / 2)
        self.width = self.height * WIDTH / HEIGHT

    def for_raio(self):
        return words(EYE, LOOK_AT, UP, FIELD_OF_VIEW)

    def for_povray(self):
        middle = plus(times(self.back, -1), times(self.side, -self.width / WIDTH / 2),
                      times(self.up, -self.height / HEIGHT / 2))
        return (f"camera {{ perspective location {pov(EYE)} direction {pov(middle)} "
                f"right {pov(times(self.side, -self.width))} up {pov(times(self.up, self.height))} }}")

    def depth(self):
        """a, b, c, d of the depth a x + b y + c z + d, from 0 at NEAR to 1 at FAR."""
        normal = times(self.back, -1 / (FAR - NEAR))
        return normal + (-dot(normal, EYE) - NEAR / (FAR - NEAR),)


def raio_scene(shapes, camera):
    return "\n".join([camera.for_raio(), "0", "1", f"texture ramp.ppm {words(camera.depth())} 0 0 0 0", "1", "lambertian",
                      str(len(shapes)), *(f"0 0 {shape[0]}" for shape in shapes), ""])


def povray_scene(shapes, camera):
    a, b, c, d = camera.depth()
    return "\n".join(["#version 3.7;", "global_settings { assumed_gamma 1.0 ambient_light rgb 1 }",
                      camera.for_povray(),
                      f"#declare depth = function {{ ({a}) * x + ({b}) * y + ({c}) * z + ({d}) }}",
                      "union {", *(shape[1] for shape in shapes),
                      f"pigment {{ function {{ depth(x, y, z) }} color_map {{ [0 rgb {DARK / 255}] [1 rgb 1] }} }}",
                      "finish { ambient 1 diffuse 0 } }", ""])


def read_ppm(path):
    """The pixels of a P6 file as (r, g, b), row by row."""
    data, fields, at = path.read_bytes(), [], 0
    while len(fields) < 4:
        end = at
        while not data[end:end + 1].isspace():
            end += 1
        if data[at:at + 1] == b"#":
            end = data.index(b"\n", at)
        elif end > at:
            fields.append(data[at:end])
        at = end + 1
    assert fields == [b"P6", b"%d" % WIDTH, b"%d" % HEIGHT, b"255"], fields
    assert len(data) == at + 3 * WIDTH * HEIGHT
    return [tuple(data[i:i + 3]) for i in range(at, len(data), 3)]


def differ(a, b):
    return max(abs(x - y) for x, y in zip(a, b)) > TOLERANCE


def at_an_edge(picture, pixel):
    row, column = divmod(pixel, WIDTH)
    near = [(r, c) for r in range(row - 1, row + 2) for c in range(column - 1, column + 2)
            if 0 <= r < HEIGHT and 0 <= c < WIDTH]
    return any(differ(picture[r * WIDTH + c], picture[pixel]) for r, c in near)


def complaint(renderer, povray, folder, name, shapes):
    """What is wrong with one scene; nothing, if both renderers agree."""
    camera = Camera()
    scene, other = folder / f"{name}.txt", folder / f"{name}.pov"
    ours, theirs = folder / f"{name}.raio.ppm", folder / f"{name}.povray.ppm"
    scene.write_text(raio_scene(shapes, camera))
    other.write_text(povray_scene(shapes, camera))
    subprocess.run([renderer, scene, "-o", ours, "--integrator", "flat", "--quiet", "--size", f"{WIDTH}x{HEIGHT}"],
                   check=True)
    run = subprocess.run([povray, f"+I{other}", f"+O{theirs}", "+FP8", f"+W{WIDTH}", f"+H{HEIGHT}", "-D", "-A", "-GA",
                          "File_Gamma=1.0"], capture_output=True, text=True)
    if run.returncode != 0:
        return f"POV-Ray failed:\n{run.stderr}"
    picture, reference = read_ppm(ours), read_ppm(theirs)
    seen = sum(differ(pixel, (0, 0, 0)) for pixel in picture)
    if seen < len(picture) // 50:
        return f"shows something in {seen} pixels only"
    wrong = [i for i in range(len(picture)) if differ(picture[i], reference[i])]
    inside = [i for i in wrong if not at_an_edge(picture, i) and not at_an_edge(reference, i)]
    if inside:
        row, column = divmod(inside[0], WIDTH)
        return (f"{len(inside)} pixels differ away from any edge, the first in row {row}, column {column}: "
                f"{picture[inside[0]]}, POV-Ray {reference[inside[0]]}")
    if len(wrong) * 1000 > len(picture):
        return f"{len(wrong)} of {len(picture)} pixels differ"
    print(f"{name}: {len(wrong)} of {len(picture)} pixels differ, all at edges")
    return ""


def main():
    renderer, povray, folder = sys.argv[1], shutil.which(sys.argv[2]), pathlib.Path(sys.argv[3])
    if povray is None:
        print("skipped: POV-Ray is not installed (apt-get install povray)")
        return 77
    folder.mkdir(parents=True, exist_ok=True)
    ramp = bytes(DARK + level * (256 - DARK) // 4096 for level in range(4096) for _ in range(3))
    (folder / "ramp.ppm").write_bytes(b"P6\n4096 1\n255\n" + ramp)
    failed = False
    for name, shapes in SCENES.items():
        wrong = complaint(renderer, povray, folder, name, shapes)
        if wrong:
            print(f"{name}: {wrong}")
            failed = True
    return 1 if failed else 0


sys.exit(main())
