// The reference renderer: raio-render SCENE [-o IMAGE] [--integrator flat|normals|whitted|path] ...

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "interruption.hpp"
#include "memory.hpp"
#include "progress.hpp"
#include "reader.hpp"
#include "renderer.hpp"

namespace {

constexpr int longest_side = 16384;  // of a picture, in pixels

struct command_line {
    std::filesystem::path scene, image;
    std::string integrator;  // empty: as the scene is lit
    std::optional<int> samples, depth;
    render::render_settings settings{.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))};
    bool quiet = false;
};

/// Without lamps all light comes from the sky and from what glows, which only paths find.
const render::integrator& chosen_integrator(const std::string& name, const render::scene& scene) {
    const std::string_view by_light = scene.lights.empty() ? "path" : "whitted";
    const std::string_view chosen = name.empty() ? by_light : name;
    return *std::ranges::find(render::integrators(), chosen, &render::integrator::name);
}

template <class Number>
bool is_number(std::string_view text, Number& value) {
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && rest == end;
}

/// Reads WIDTHxHEIGHT.
void read_size(const std::string& text, render::render_settings& settings) {
    const std::string_view both = text, width = both.substr(0, both.find('x'));
    const std::string_view height = both.substr(std::min(both.size(), width.size() + 1));
    const auto side = [](std::string_view side_text, int& value) {
        return is_number(side_text, value) && value >= 1 && value <= longest_side;
    };
    if (!side(width, settings.width) || !side(height, settings.height)) {
        const std::string expected = "WIDTHxHEIGHT, each from 1 to " + std::to_string(longest_side);
        throw CLI::ValidationError("--size", "found " + text + ", expected " + expected);
    }
}

/// Throws `CLI::ParseError`, if only to say that help was asked for.
command_line parsed(CLI::App& app, int argc, char** argv) {
    command_line given;
    std::string how, samples, depths;
    std::vector<std::string> names;
    for (const render::integrator& i : render::integrators()) {
        const std::string name = names.emplace_back(i.name);
        how += "\n" + name + ": " + std::string(i.description);
        samples += ", " + name + " " + std::to_string(i.samples);
        depths += ", " + name + " " + std::to_string(i.depth);
    }
    const auto seed = [](const std::string& text) -> std::string {
        std::uint64_t value{};
        return is_number(text, value) ? "" : "found " + text + ", expected a whole number below 2^64";
    };
    const auto from_to = [](int low, int high) { return CLI::Range(low, high).description(""); };

    app.add_option("SCENE", given.scene, "The scene file")->required()->type_name("FILE");
    app.add_option("-o,--output", given.image,
                   "The picture, .png or .ppm (default: in this folder, named as the scene)")
        ->type_name("IMAGE");
    app.add_option("--integrator", given.integrator,
                   "How light is followed (default: whitted, path for a scene without lamps)" + how)
        ->check(CLI::IsMember(names).description(""))
        ->type_name("NAME");
    const auto size = [&](const std::string& text) { read_size(text, given.settings); };
    app.add_option_function<std::string>("--size", size, "Pixels (default: 800x600)")->type_name("WxH");
    app.add_option("--samples", given.samples,
                   "Rays for each pixel, a power of two at best (default: " + samples.substr(2) + ")")
        ->check(from_to(1, 1 << 30))
        ->type_name("N");
    app.add_option("--depth", given.depth, "How often light may bounce (default: " + depths.substr(2) + ")")
        ->check(from_to(0, 1000))
        ->type_name("N");
    app.add_option("--threads", given.settings.threads, "They change the time, not the picture (default: one a core)")
        ->check(from_to(1, 1024))
        ->type_name("N");
    app.add_option("--seed", given.settings.seed, "Which random numbers are drawn (default: 0)")
        ->check(seed)
        ->type_name("N");
    app.add_flag("--quiet", given.quiet, "No progress bar (nor is there one unless standard error is a terminal)");
    app.parse(argc, argv);

    if (given.image.empty()) given.image = given.scene.stem() += ".png";
    return given;
}

/// The scene, whose files the picture may not overwrite.
render::scene read(const command_line& given) {
    std::vector<std::filesystem::path> files{given.scene};
    const auto noted = [&](auto load) {
        return [&files, load](const std::filesystem::path& file) { return files.push_back(file), load(file); };
    };
    const render::loaders load{noted(render::read_texture),
                               noted([](const auto& file) { return render::read_mesh(file); })};
    render::scene scene = render::with_memory_for("the scene " + given.scene.string(),
                                                  [&] { return render::read_scene(given.scene, load); });
    render::expect_other_file(given.image, files);
    render::expect_writable(given.image);
    return scene;
}

/// Renders, and keeps what was rendered where a signal comes. The exit status.
int run(const command_line& given) {
    render::scene scene = read(given);
    const render::integrator& integrator = chosen_integrator(given.integrator, scene);
    render::render_settings settings = given.settings;
    settings.samples = given.samples.value_or(integrator.samples);
    settings.depth = given.depth.value_or(integrator.depth);
    if (!integrator.is_lit(scene)) {
        std::fprintf(stderr,
                     "%s: nothing lights the scene (no lamp, no emissive material, no background): all is black\n",
                     given.scene.string().c_str());
    }
    const auto world =
        render::with_memory_for("the tree of the scene's shapes", [&] { return render::world(std::move(scene)); });

    const std::string size = std::to_string(settings.width) + "x" + std::to_string(settings.height);
    const render::interruption interruption;
    render::progress progress(settings.height, given.quiet);
    render::with_memory_for("a picture of " + size + " pixels", [&] {
        const auto picture = render::rendered(
            world, integrator, settings, [&] { progress.step(); }, [&] { return interruption.signal() != 0; });
        if (progress.done() > 0) render::write_image(picture, given.image);
    });
    progress.clear();

    const std::string image = given.image.string();
    if (progress.done() == settings.height) {
        if (progress.is_shown()) std::fprintf(stderr, "The picture is %s\n", image.c_str());
        return 0;
    }
    if (progress.done() > 0) {
        std::fprintf(stderr, "raio-render: interrupted; %s has %d of %d rows, and is black where it is not rendered\n",
                     image.c_str(), progress.done(), settings.height);
    } else {
        std::fprintf(stderr, "raio-render: interrupted before a row was rendered; there is no new picture\n");
    }
    return 128 + interruption.signal();  // as shells say it
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Renders a scene file: a picture of what its camera sees.", "raio-render");
    try {
        return run(parsed(app, argc, argv));
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "raio-render: %s; see raio-render --help\n", error.what());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "raio-render: out of memory\n");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    return 2;
}
