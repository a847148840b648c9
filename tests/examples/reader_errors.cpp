#include <filesystem>
#include <fstream>
#include <string>

#include <doctest/doctest.h>
#include <render/reader.hpp>

#include "errors.hpp"
#include "reader_text.hpp"

namespace {

using namespace render;

struct bad_scene {
    std::string name;
    scene_text text;
    std::string message;  ///< behind `scenes/test.txt:`
};

std::string repeated(std::string_view words, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += words;
    return all;
}

const std::string many_digits(300, '9'), long_word(1'000'000, 'x');
const std::string shapes =
    "a shape: algebraic, bezier_curve, bilinear_patch, blob, box, capsule, circle, cone, curved_surface_of_revolution, cylinder, difference, disc, ellipsoid, "
    "frustum, heightfield, hyperboloid, intersection, mesh, open_algebraic, open_cone, open_cylinder, "
    "open_frustum, open_hyperboloid, open_paraboloid, open_quadric, open_two_sheet_hyperboloid, oriented_box, "
    "paraboloid, parallelogram, plane, polyhedron, prism, pyramid, quadric, regular_solid, ring, round_cone, "
    "signed_distance, sphere, steiner, surface_of_revolution, teardrop, tetrahedron, torus, triangle, two_sheet_hyperboloid, union; or a transform: rotate, scale, translate";
const std::string statements = "the end of the file or a statement: aperture, background, fog, sky";

const bad_scene bad_camera[] = {
    {"a word for a number", {.camera = "0 zero 5"}, "1: found 'zero', expected a number for the camera's eye"},
    {"a number that ends in letters", {.camera = "0 5cm"}, "1: found '5cm', expected a number for the camera's eye"},
    {"a decimal comma", {.camera = "0 0,5"}, "1: found '0,5', expected a number for the camera's eye"},
    {"a hexadecimal number", {.camera = "0 0x5"}, "1: found '0x5', expected a number for the camera's eye"},
    {"two signs", {.camera = "0 +-5"}, "1: found '+-5', expected a number for the camera's eye"},
    {"NaN", {.camera = "0 nan"}, "1: found 'nan', expected a number for the camera's eye"},
    {"infinity", {.camera = "-inf"}, "1: found '-inf', expected a number for the camera's eye"},
    {"overflow",
     {.camera = "1e400"},
     "1: found '1e400', expected 0 or a magnitude from 1e-50 to 1e50 for the camera's eye"},
    {"underflow",
     {.camera = "1e-400"},
     "1: found '1e-400', expected 0 or a magnitude from 1e-50 to 1e50 for the camera's eye"},
    {"too large",
     {.camera = "-2e50"},
     "1: found '-2e50', expected 0 or a magnitude from 1e-50 to 1e50 for the camera's eye"},
    {"too small",
     {.camera = "9e-51"},
     "1: found '9e-51', expected 0 or a magnitude from 1e-50 to 1e50 for the camera's eye"},
    {"the eye is the point to look at",
     {.camera = "1 2 3\n1 2 3\n0 1 0\n60"},
     "2: found the eye again, expected another point to look at"},
    {"no up", {.camera = "0 0 5\n0 0 0\n0 0 0\n60"}, "3: found 0 0 0, expected a direction for the camera's up"},
    {"up along the view",
     {.camera = "1 2 3\n0 0 0\n0.1 0.2 0.3\n60"},
     "3: found an up along the view, expected another direction for the camera's up"},
    {"up against the view, all of it tiny",
     {.camera = "1e-50 0 0\n0 0 0\n-1e-50 0 0\n60"},
     "3: found an up along the view, expected another direction for the camera's up"},
    {"no field of view",
     {.camera = "0 0 5\n0 0 0\n0 1 0\n0"},
     "4: found '0', expected an angle above 0 and below 180 for the vertical field of view"},
    {"a field of view of a half turn",
     {.camera = "0 0 5\n0 0 0\n0 1 0\n180"},
     "4: found '180', expected an angle above 0 and below 180 for the vertical field of view"},
};

const bad_scene bad_counts[] = {
    {"a count that is negative",
     {.lights = "-1"},
     "2: found '-1', expected a whole number not below 0 for the count of lights"},
    {"a count that is not whole",
     {.lights = "1.0"},
     "2: found '1.0', expected a whole number not below 0 for the count of lights"},
    {"a word for a count",
     {.lights = "one"},
     "2: found 'one', expected a whole number not below 0 for the count of lights"},
    {"a count that the file cannot hold",
     {.lights = "4000000000 1 2 3"},
     "2: found '4000000000', expected at most 33 lights in what is left of the file"},
    {"a count beyond all integers",
     {.objects = "99999999999999999999 0"},
     "5: found '99999999999999999999', expected at most 1 objects in what is left of the file"},
    {"a count of 300 digits",
     {.objects = many_digits},
     "5: found '9999999999999999999999999999999999999999...', expected at most 0 objects in what is left of the file"},
    {"a mesh less a ball",
     {.objects = "1 0 0 difference 2 mesh square.obj 0 0 0 1"},
     "5: found a mesh inside of another shape, expected one that stands alone"},
    {"a mesh that is moved beyond all numbers",
     {.objects = "1 0 0 translate 1e50 1e50 0 mesh square.obj 0 0 0 1"},
     "5: found a mesh that reaches beyond 1e50, expected a lesser scale or offset"},
    {"a mesh without a size",
     {.objects = "1 0 0 mesh square.obj 0 0 0 0"},
     "5: found '0', expected a number above 0 for the scale of a mesh"},
    {"a mesh beyond all numbers",
     {.objects = "1 0 0 mesh square.obj 0 0 0 6e49"},
     "5: found a mesh that reaches beyond 1e50, expected a lesser scale or offset"},
    {"a polyhedron of too many planes",
     {.objects = "1 0 0 polyhedron 1000000 1 2 3 4"},
     "5: found '1000000', expected at most 4 planes of a polyhedron in what is left of the file"},
    {"one light too many is a pigment short",
     {.lights = "2  0 9 0  1 1 1  1 0 0"},
     "3: found 'solid', expected a number for the position of a light"},
    {"one light too few", {.lights = "0  1 9 0"}, "2: found '9', expected a pigment: checker, solid, texture"},
};

const bad_scene bad_looks[] = {
    {"negative attenuation",
     {.lights = "1  0 9 0  1 1 1  1 0 -1"},
     "2: found '-1', expected a number not below 0 for the attenuation of a light"},
    {"no attenuation",
     {.lights = "1  0 9 0  1 1 1  0 0 0"},
     "2: found 0 0 0, expected an attenuation that is not 0 everywhere"},
    {"an unknown pigment",
     {.pigments = "1 marble 1 0 0"},
     "3: found 'marble', expected a pigment: checker, solid, texture"},
    {"a checker without size",
     {.pigments = "1 checker 1 1 1 0 0 0 0"},
     "3: found '0', expected a number above 0 for the size of a checker"},
    {"a texture that is not there",
     {.pigments = "1 texture none.png 1 0 0 0 0 1 0 0"},
     "3: found no picture in the texture 'none.png' (no such picture), expected a picture file, named from the scene's folder"},
    {"an unknown material",
     {.materials = "1 plastic"},
     "4: found 'plastic', expected seven numbers or a material by name: dielectric, emissive, lambertian, metal"},
    {"neither number nor name", {.materials = "1 ?"}, "4: found '?', expected a number for ka of a material"},
    {"a negative exponent",
     {.materials = "1 0 0 0 -1"},
     "4: found '-1', expected a number not below 0 for alpha of a material"},
    {"transmission without an index",
     {.materials = "1 0 0 0 0 0 1 0"},
     "4: found '0', expected a number above 0 for ior of a material"},
    {"a fuzz above 1",
     {.materials = "1 metal 1.5"},
     "4: found '1.5', expected a number from 0 to 1 for the fuzz of a metal"},
    {"a vacuum of index 0",
     {.materials = "1 dielectric 0"},
     "4: found '0', expected a number above 0 for the refractive index of a dielectric"},
    {"negative light",
     {.materials = "1 emissive 1 -1 1"},
     "4: found '-1', expected a number not below 0 for the radiance of an emissive material"},
};

const bad_scene bad_objects[] = {
    {"a pigment out of range",
     {.objects = "1 1 0 sphere"},
     "5: found '1', expected the index of a pigment, from 0 to 0"},
    {"a material out of range",
     {.materials = "2 lambertian lambertian", .objects = "1 0 2 sphere"},
     "5: found '2', expected the index of a material, from 0 to 1"},
    {"a negative index",
     {.objects = "1 -1 0 sphere"},
     "5: found '-1', expected a whole number not below 0 for the index of a pigment"},
    {"an index beyond all integers",
     {.objects = "1 99999999999999999999 0 sphere"},
     "5: found '99999999999999999999', expected the index of a pigment, from 0 to 0"},
    {"no pigment to choose from", {.pigments = "0"}, "5: found '0', expected no object, since there is no pigment"},
    {"an unknown shape", {.objects = "1 0 0 teapot 0 0 0 1"}, "5: found 'teapot', expected " + shapes},
    {"a misspelt transform",
     {.objects = "1 0 0 rotat 0 1 0 30 sphere 0 0 0 1"},
     "5: found 'rotat', expected " + shapes},
    {"a misspelt transform behind another",
     {.objects = "1 0 0 scale 1 1 2 rotat 0 1 0 30 sphere 0 0 0 1"},
     "5: found 'rotat', expected " + shapes},
    {"a shape in capitals", {.objects = "1 0 0 Sphere 0 0 0 1"}, "5: found 'Sphere', expected " + shapes},
    {"radius 0",
     {.objects = "1 0 0 sphere 0 0 0 0"},
     "5: found '0', expected a number above 0 for the radius of a sphere"},
    {"a negative radius",
     {.objects = "1 0 0 sphere 0 0 0 -1"},
     "5: found '-1', expected a number above 0 for the radius of a sphere"},
    {"a plane without normal",
     {.objects = "1 0 0 plane 0 0 0 0 0 -0"},
     "5: found 0 0 0, expected a direction for the normal of a plane"},
    {"a disc without normal",
     {.objects = "1 0 0 disc 0 0 0 0 0 0 1"},
     "5: found 0 0 0, expected a direction for the normal of a disc"},
    {"a circle without radius",
     {.objects = "1 0 0 circle 0 0 0 0 1 0 0"},
     "5: found '0', expected a number above 0 for the radius of a disc"},
    {"a triangle of equal corners",
     {.objects = "1 0 0 triangle 0 0 0 1 1 1 1 1 1"},
     "5: found a triangle without area, expected corners that are not on one line"},
    {"a triangle on a line",
     {.objects = "1 0 0 triangle 0 0 0 1 1 1 2 2 2"},
     "5: found a triangle without area, expected corners that are not on one line"},
    {"a cylinder without axis",
     {.objects = "1 0 0 cylinder 0 0 0 0 0 0 1 1"},
     "5: found 0 0 0, expected a direction for the axis of a cylinder"},
    {"a cylinder without radius",
     {.objects = "1 0 0 cylinder 0 0 0 0 1 0 0 1"},
     "5: found '0', expected a number above 0 for the radius of a cylinder"},
    {"a tube of negative height",
     {.objects = "1 0 0 open_cylinder 0 0 0 0 1 0 1 -1"},
     "5: found '-1', expected a number above 0 for the height of a cylinder"},
    {"a cylinder lower than the rounding of its base",
     {.objects = "1 0 0 cylinder 0 1e20 0 0 1 0 1 1"},
     "5: found a height that is lost in the rounding of the base, expected a higher cylinder"},
    {"a bilinear patch without area",
     {.objects = "1 0 0 bilinear_patch 0 0 0 1 2 3 2 4 6 3 6 9"},
     "5: found a bilinear patch without area, expected corners that are not on one line"},
    {"a heightfield without width",
     {.objects = "1 0 0 heightfield 0 0 0 1 2 2 0 0 0 0"},
     "5: found a heightfield without width, expected the lesser coordinates first"},
    {"a heightfield of one row",
     {.objects = "1 0 0 heightfield 0 0 1 1 2 1 0 0"},
     "5: found a heightfield without a cell, expected two columns and two rows at least"},
    {"a heightfield of one height too few",
     {.objects = "1 0 0 heightfield 0 0 1 1 2 2 0 0 0"},
     "5: found the end of the file, expected a number for a height of a heightfield"},
    {"a heightfield of one height too many",
     {.objects = "1 0 0 heightfield 0 0 1 1 2 2 0 0 0 0 7"},
     "5: found '7', expected the index of a pigment, from 0 to 0"},
    {"a round cone without top",
     {.objects = "1 0 0 round_cone 0 0 0 0 2 0 1 0"},
     "5: found '0', expected a number above 0 for the top radius of a round cone"},
    {"a Bezier curve without radius",
     {.objects = "1 0 0 bezier_curve 0 0 0 1 0 0 2 0 0 3 0 0  0 0 0 0"},
     "5: found radii that are all 0, expected one above 0 at least"},
    {"a parallelogram without area",
     {.objects = "1 0 0 parallelogram 0 0 0 1 2 3 2 4 6"},
     "5: found a parallelogram without area, expected edges that are not on one line"},
    {"a torus without axis",
     {.objects = "1 0 0 torus 0 0 0 0 0 0 1 1"},
     "5: found 0 0 0, expected a direction for the axis of a torus"},
    {"a torus without circle",
     {.objects = "1 0 0 torus 0 0 0 0 1 0 0 1"},
     "5: found '0', expected a number above 0 for the major radius of a torus"},
    {"a torus without tube",
     {.objects = "1 0 0 torus 0 0 0 0 1 0 1 0"},
     "5: found '0', expected a number above 0 for the minor radius of a torus"},
    {"a ring inside out",
     {.objects = "1 0 0 ring 0 0 0 0 1 0 2 1"},
     "5: found an inner radius that is not below the outer one, expected the smaller radius first"},
    {"a cone without height",
     {.objects = "1 0 0 cone 0 1 0 0 1 0 1"},
     "5: found a cone without height, expected two points that differ"},
    {"a cone without radius",
     {.objects = "1 0 0 open_cone 0 0 0 0 1 0 0"},
     "5: found '0', expected a number above 0 for the radius of a cone"},
    {"a frustum with a radius below 0",
     {.objects = "1 0 0 frustum 0 0 0 0 1 0 1 -1"},
     "5: found '-1', expected a number not below 0 for the top radius of a frustum"},
    {"a paraboloid without height",
     {.objects = "1 0 0 paraboloid 0 1 0 0 1 0 1"},
     "5: found a paraboloid without height, expected two points that differ"},
    {"a hyperboloid without waist",
     {.objects = "1 0 0 hyperboloid 0 0 0 0 1 0 0 1"},
     "5: found '0', expected a number above 0 for the waist radius of a hyperboloid"},
    {"a hyperboloid whose gap is as long as the axis",
     {.objects = "1 0 0 two_sheet_hyperboloid 0 0 0 0 1 0 1 1"},
     "5: found '1', expected a number between 0 and 1 for the gap of a hyperboloid"},
    {"an ellipsoid with a radius of 0",
     {.objects = "1 0 0 ellipsoid 0 0 0 1 0 1"},
     "5: found '0', expected a number above 0 for the radii of an ellipsoid"},
    {"a capsule without radius",
     {.objects = "1 0 0 capsule 0 0 0 0 1 0 0"},
     "5: found '0', expected a number above 0 for the radius of a capsule"},
    {"a tetrahedron in a plane",
     {.objects = "1 0 0 tetrahedron 0 0 0 1 0 0 0 1 0 1 1 0"},
     "5: found a tetrahedron without volume, expected corners that do not lie in one plane"},
    {"a pyramid over a line",
     {.objects = "1 0 0 pyramid 2 0 0 0 1 0 0 0 1 0"},
     "5: found 2 corners, expected a base of 3 to 12"},
    {"a prism along its base",
     {.objects = "1 0 0 prism 3 0 0 0 1 0 0 0 1 0 1 1 0"},
     "5: found a prism without volume, expected corners that do not lie in one plane"},
    {"a regular solid of seven faces",
     {.objects = "1 0 0 regular_solid 7 0 0 0 1"},
     "5: found '7', expected 4, 6, 8, 12 or 20 for the faces of a regular solid"},
    {"a profile on the axis",
     {.objects = "1 0 0 surface_of_revolution 0 0 0 0 1 0 2 0 0 0 1"},
     "5: found a profile that sweeps no area, expected two points or more, not all on the axis"},
    {"a curved profile of five points",
     {.objects = "1 0 0 curved_surface_of_revolution 0 0 0 0 1 0 5 0 0 1 0 1 1 0 1 0 2"},
     "5: found 5 points, expected 4, and 3 for each curve more"},
    {"a curved profile on the axis",
     {.objects = "1 0 0 curved_surface_of_revolution 0 0 0 0 1 0 4 0 0 0 1 0 2 0 3"},
     "5: found a profile that sweeps no area, expected points that are not all on the axis"},
    {"a box inside out",
     {.objects = "1 0 0 box 0 0 0 1 -1 1"},
     "5: found a minimum above the maximum of a box, expected the lesser coordinates first"},
    {"a box that is a line",
     {.objects = "1 0 0 box 0 0 0 1 0 0"},
     "5: found a box without area, expected sizes that are 0 along one axis at most"},
    {"a quadric in a flat box",
     {.objects = "1 0 0 quadric 0 0 0 1 0 1"},
     "5: found a minimum that is not below the maximum of the box of a quadric, expected the lesser coordinates first"},
    {"a quadric that is constant",
     {.objects = "1 0 0 quadric 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 -1"},
     "5: found a quadric that is the same everywhere, expected coefficients that are not all 0"},
    {"an algebraic surface with half a power",
     {.objects = "1 0 0 algebraic 0 0 0 1 1 1 1 1 0.5 0 0"},
     "5: found '0.5', expected a whole number from 0 to 8 for a power of an algebraic surface"},
    {"an algebraic surface of degree 9",
     {.objects = "1 0 0 open_algebraic 0 0 0 1 1 1 1 1 3 3 3"},
     "5: found a term of degree 9, expected at most 8"},
    {"an algebraic surface without terms",
     {.objects = "1 0 0 algebraic 0 0 0 1 1 1 0"},
     "5: found an algebraic surface that is the same everywhere, expected a term with a power above 0"},
    {"a Steiner surface without size",
     {.objects = "1 0 0 steiner 0 0 0 0"},
     "5: found '0', expected a number above 0 for the size of a Steiner surface"},
    {"a teardrop without height",
     {.objects = "1 0 0 teardrop 0 1 0 0 1 0 1"},
     "5: found the bottom again, expected another tip of a teardrop"},
    {"a blob of nothing", {.objects = "1 0 0 blob 0.5 0"}, "5: found 0 components, expected a blob of 1 to 16"},
    {"a blob without threshold",
     {.objects = "1 0 0 blob 0 1 0 0 0 1 1"},
     "5: found '0', expected a number above 0 for the threshold of a blob"},
    {"a blob's capsule with one end",
     {.objects = "1 0 0 blob 1 1 capsule 0 0 0 1 1"},
     "5: found the end of the file, expected a number for the other end of a blob's capsule"},
    {"a signed distance in a flat box",
     {.objects = "1 0 0 signed_distance 0 0 0 1 0 1"},
     "5: found a minimum that is not below the maximum of the box of a signed distance, expected the lesser coordinates first"},
    {"a shape for a distance function",
     {.objects = "1 0 0 signed_distance 0 0 0 1 1 1 sphere 0 0 0 1"},
     "5: found 'sphere', expected a distance function: ball, blend, block, difference, gyroid, intersection, offset, shell, union"},
    {"a block without width",
     {.objects = "1 0 0 signed_distance 0 0 0 1 1 1 block 0 0 0 1 0 1"},
     "5: found '0', expected a number above 0 for the half edges of a block"},
    {"a blend of one",
     {.objects = "1 0 0 signed_distance 0 0 0 1 1 1 blend 1 1 ball 0 0 0 1"},
     "5: found less than two distance functions to join, expected at least two"},
    {"a polyhedron without planes",
     {.objects = "1 0 0 polyhedron 0"},
     "5: found a polyhedron without planes, expected at least one"},
    {"a polyhedron's plane without normal",
     {.objects = "1 0 0 polyhedron 1 0 0 0 1"},
     "5: found 0 0 0, expected a direction for the normal of a polyhedron's plane"},
};

const bad_scene bad_compositions[] = {
    {"a scale that leaves a plane",
     {.objects = "1 0 0 scale 1 0 1 sphere 0 0 0 1"},
     "5: found '0', expected a number other than 0 for the factors of a scale"},
    {"a rotation about nothing",
     {.objects = "1 0 0 rotate 0 0 0 90 sphere 0 0 0 1"},
     "5: found 0 0 0, expected a direction for the axis of a rotation"},
    {"a rotation without angle",
     {.objects = "1 0 0 rotate 0 0 1 sphere 0 0 0 1"},
     "5: found 'sphere', expected a number for the angle of a rotation"},
    {"scales that overflow",
     {.objects = "1 0 0 scale 1e50 1e50 1e50 scale 1e50 1e50 1e50 sphere 0 0 0 1"},
     "5: found transforms that lead out of the range of numbers, expected scales nearer to 1"},
    {"scales that vanish",
     {.objects = "1 0 0 " + repeated("scale 1e-50 1 1\n", 8) + "sphere 0 0 0 1"},
     "12: found transforms that lead out of the range of numbers, expected scales nearer to 1"},
    {"a transform of nothing", {.objects = "1 0 0 translate 0 0 0 0 0"}, "5: found '0', expected " + shapes},
    {"a union of one",
     {.objects = "1 0 0 union 1 sphere 0 0 0 1"},
     "5: found less than two solids of a union, expected at least two"},
    {"an intersection of none",
     {.objects = "1 0 0 intersection 0"},
     "5: found less than two solids of an intersection, expected at least two"},
    {"a difference of more than there are",
     {.objects = "1 0 0 difference 20 sphere 0 0 0 1"},
     "5: found '20', expected at most 8 solids of a difference in what is left of the file"},
    {"half of a union",
     {.objects = "1 0 0 union 2\nsphere 0 0 0 1", .statements = "background 0 0 0"},
     "7: found 'background', expected " + shapes},
    {"a disc less a sphere",
     {.objects = "1 0 0 difference 2\ndisc 0 0 0  0 1 0  1\nsphere 0 0 0 1"},
     "6: found a shape without an inside, expected a solid to combine with others"},
    {"a sphere less a disc that was moved",
     {.objects = "1 0 0 difference 2\nsphere 0 0 0 1\nscale 2 2 2 disc 0 0 0  0 1 0  1"},
     "7: found a shape without an inside, expected a solid to combine with others"},
    {"shells without end",
     {.objects = "1 0 0 signed_distance 0 0 0 1 1 1 " + repeated("shell 1 ", 100'000)},
     "5: found a shape that stands in more than 100 others, expected fewer"},
    {"nested without end",
     {.objects = "1 0 0 " + repeated("union 2 ", 100'000)},
     "5: found a shape that stands in more than 100 others, expected fewer"},
};

const bad_scene web_colors[] = {
    {"alone",
     {.pigments = "2 solid #ff0000\nsolid 0 1 0"},
     "3: found '#ff0000', which begins a comment, expected a number for the colour of a pigment"},
    {"with the numbers of another one to take",
     {.pigments = "1 solid #F00 a comment\n0 1 0"},
     "3: found '#F00', which begins a comment, expected a number for the colour of a pigment"},
    {"behind a colour",
     {.pigments = "1 checker 1 1 1 #00ff0080 1\n0 0 0 1"},
     "3: found '#00ff0080', which begins a comment, expected a number for the second colour of a checker"},
    {"of a lamp",
     {.lights = "1  0 9 0  #ffff 1 0 0\n1 1 1  1 0 0"},
     "2: found '#ffff', which begins a comment, expected a number for the colour of a light"},
    {"of what shines",
     {.materials = "1 emissive #ffffff\n1 1 1"},
     "4: found '#ffffff', which begins a comment, expected a number not below 0 for the radiance of an emissive "
     "material"},
};

const bad_scene bad_statements[] = {
    {"a wrong object beyond the count",
     {.statements = "0 0 sphere 0 0 0 1\n0 1 sphere 0 0 0 1"},
     "7: found '1', expected the index of a material, from 0 to 0"},
    {"no object and no statement", {.statements = "-1"}, "6: found '-1', expected " + statements},
    {"an unknown statement", {.statements = "\n\nmist 1 1 1 0"}, "8: found 'mist', expected " + statements},
    {"a web colour for a background",
     {.statements = "background #80f\n1 1 1"},
     "6: found '#80f', which begins a comment, expected a number not below 0 for the colour of the background"},
    {"the background twice",
     {.statements = "background 0 0 0\nbackground 1 1 1"},
     "7: found a second statement that sets the background, expected one at most"},
    {"background and sky",
     {.statements = "background 0 0 0\nsky 1 1 1 0 0 0"},
     "7: found a second statement that sets the background, expected one at most"},
    {"a negative background",
     {.statements = "background 0 -1 0"},
     "6: found '-1', expected a number not below 0 for the colour of the background"},
    {"half a sky",
     {.statements = "sky 1 1 1"},
     "6: found the end of the file, expected a number not below 0 for the upper colour of the sky"},
    {"fog that brightens",
     {.statements = "fog 1 1 1 -1"},
     "6: found '-1', expected a number not below 0 for the density of the fog"},
    {"a negative aperture",
     {.statements = "aperture -1 1"},
     "6: found '-1', expected a number not below 0 for the diameter of the aperture"},
    {"a focus at the eye",
     {.statements = "aperture 1 0"},
     "6: found '0', expected a number above 0 for the distance of the focus"},
};

const bad_scene bad_bytes[] = {
    {"binary",
     {.camera = std::string("\x7f"
                            "ELF\0\x01\xff",
                            7)},
     "1: found '\\x7fELF\\x00\\x01\\xff', expected a number for the camera's eye"},
    {"a line that never ends",
     {.camera = "0 0 5 " + long_word},
     "1: found 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...', expected a number for the point to look at"},
    {"a comment without white space before it",
     {.camera = "0 0#5"},
     "1: found '0#5', expected a number for the camera's eye"},
};

std::string text_error(const std::string& text) {
    return error_of([&] { parse_scene(text, "scenes/test.txt", no_files); });
}

template <std::size_t N>
void check(const bad_scene (&rows)[N]) {
    for (const bad_scene& row : rows) {
        CAPTURE(row.name);
        CHECK(text_error(row.text.joined()) == "scenes/test.txt:" + row.message);
    }
}

std::string file_error(const std::filesystem::path& file) {
    return error_of([&] { read_scene(file); });
}

}  // namespace

TEST_CASE("a wrong camera is named with its line") { check(bad_camera); }
TEST_CASE("a wrong count is named with its line") { check(bad_counts); }
TEST_CASE("a wrong light, pigment or material is named with its line") { check(bad_looks); }
TEST_CASE("a wrong object is named with its line") { check(bad_objects); }
TEST_CASE("a wrong transform or combination is named with its line") { check(bad_compositions); }
TEST_CASE("a web colour is refused, since it begins a comment and other numbers would be taken") { check(web_colors); }
TEST_CASE("comments of the same look are none where no colour is expected, nor are other words") {
    const scene s = read({.pigments = "1  #123456\nsolid  #dawn\n 1 0 0  #ff0000", .materials = "1 #fff\nlambertian"});
    CHECK(std::get<solid>(s.pigments.at(0)).value == color(1, 0, 0));
}
TEST_CASE("a wrong statement is named with its line") { check(bad_statements); }
TEST_CASE("bytes that are no text are shown as text") { check(bad_bytes); }

TEST_CASE("an empty scene ends on its first line") {
    const std::string message = "scenes/test.txt:1: found the end of the file, expected a number for the camera's eye";
    CHECK(text_error("") == message);
    CHECK(text_error("\n\n# nothing but words\n") == message);
}

TEST_CASE("a scene that is cut anywhere is refused on the line where it ends") {
    const std::string text = scene_text{}.joined();
    for (std::size_t size = 0; size + 3 < text.size();
         ++size) {  // behind that only the last radius and a line's end are cut
        const std::string cut = text.substr(0, size), message = text_error(cut);
        CAPTURE(cut);
        CHECK(message != "no error");
        CHECK(message.find('\n') == message.npos);
    }
    CHECK(text_error(text.substr(0, text.find("1  0 0 sphere") + 13) + "\n\n\n") ==
          "scenes/test.txt:5: found the end of the file, expected a number for the centre of a sphere");
}

TEST_CASE("a file that is no scene is refused by name") {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "raio-reader-test";
    std::filesystem::create_directories(folder);
    const std::string missing = (folder / "missing.txt").string(), empty = (folder / "empty.txt").string();
    std::ofstream(empty).close();
    CHECK(file_error(missing) == missing + ":1: found no such file, expected a scene file");
    CHECK(file_error(folder) == folder.string() + ":1: found a directory, expected a scene file");
    CHECK(file_error(empty) == empty + ":1: found the end of the file, expected a number for the camera's eye");
    if (std::filesystem::exists("/dev/zero")) {
        CHECK(file_error("/dev/zero") == "/dev/zero:1: found a device, expected a scene file");
    }

    const std::string scene = (folder / "texture.txt").string();
    std::ofstream(scene) << scene_text{.pigments = "1\ntexture empty.txt 1 0 0 0 0 1 0 0"}.joined();
    CHECK(file_error(scene) == scene +
                                   ":4: found no picture in the texture 'empty.txt' (cannot be read, or is empty), "
                                   "expected a picture file, named from the scene's folder");
    std::filesystem::remove_all(folder);
}
