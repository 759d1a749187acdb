// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"
#include "cli/options/number_option.h"

#include "base/log.h"
#include "base/print.h"
#include "base/suggest.h"
#include "base/text.h"
#include "image/colour.h"
#include "image/exr.h"
#include "image/flip.h"
#include "image/ldr.h"
#include "image/metrics.h"
#include "shared/develop.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ghost::app {
namespace {

constexpr float kMinPixelsPerDegree = 5;
constexpr float kMaxPixelsPerDegree = 300;

struct CompareArguments {
    std::string test;
    std::string reference;
    std::vector<std::string> max;
    std::vector<std::string> min;
    std::vector<std::string> masked_out;
    std::optional<float> ev100;
    std::string difference;
    float pixels_per_degree = image::kFlipPixelsPerDegree;
    bool json = false;
    bool quiet = false;
};

// In the order in which they are printed. linear: only of .exr files.
struct MetricName {
    const char* name;
    bool linear;
    bool more_is_better;
};
constexpr MetricName kMetrics[] = {
    {"flip", false, false},     {"flip_p99", false, false},      {"flip_max", false, false},
    {"relmse", true, false},    {"relmse_trimmed", true, false}, {"psnr", false, true},
    {"psnr_p75", true, true},   {"bias", true, false},           {"max_error", true, false},
    {"p99_error", true, false},
};

struct Metric {
    std::string name;
    double value = 0;
};

struct Gate {
    std::string name;
    double limit = 0;
    bool is_minimum = false;
};

struct Picture {
    image::ImageF pixels;
    bool linear = false; // Rec.2020; else sRGB-coded display values
};

struct Comparison {
    std::vector<Metric> metrics;
    std::size_t counted = 0;
    std::size_t non_finite = 0;
    std::optional<double> ev100;
    std::optional<image::FlipExposures> exposures;
};

bool parse_number(const std::string& text, double& number) {
    try {
        std::size_t used = 0;
        number = std::stod(text, &used);
        return used == text.size() && std::isfinite(number);
    } catch (const std::exception&) {
        return false;
    }
}

Result<Gate> parse_gate(const std::string& text, bool is_minimum) {
    const std::string option = is_minimum ? "--min" : "--max";
    const std::size_t equals = text.find('=');
    Gate gate{text.substr(0, equals), 0, is_minimum};
    if (equals == std::string::npos || !parse_number(text.substr(equals + 1), gate.limit))
        return Error{"'" + text + "' is not METRIC=VALUE, for example " +
                         (is_minimum ? "psnr=45" : "flip=0.02"),
                     option};
    std::vector<std::string> names;
    for (const MetricName& metric : kMetrics) {
        names.emplace_back(metric.name);
        if (gate.name != metric.name) continue;
        if (metric.more_is_better != is_minimum)
            return Error{gate.name + " is better when it is " + (is_minimum ? "less" : "more") + ", use " +
                             (is_minimum ? "--max " : "--min ") + text,
                         option};
        return gate;
    }
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    return Error{"unknown metric '" + gate.name + "'" + did_you_mean(gate.name, names) + " (known: " + known +
                     ")",
                 option};
}

Result<image::Circle> parse_circle(const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        double number = 0;
        if (!parse_number(text.substr(from, comma - from), number)) break;
        numbers.push_back(number);
        from = comma + 1;
    }
    if (numbers.size() != 3 || std::count(text.begin(), text.end(), ',') != 2 || numbers[2] < 0)
        return Error{"'" + text + "' is not X,Y,RADIUS in pixels, for example 512,80,12", "--mask-out"};
    return image::Circle{static_cast<float>(numbers[0]), static_cast<float>(numbers[1]),
                         static_cast<float>(numbers[2])};
}

Result<Picture> read_linear(const std::string& path) {
    TRY(const image::ExrFile file, image::read_exr(path));
    int channel[3];
    for (int k = 0; k < 3; ++k) {
        const std::string name(1, "RGB"[k]);
        channel[k] = file.find_channel(name);
        if (channel[k] < 0) return Error{"has no channel " + name + ", expected R, G, B", path};
    }
    if (!file.chromaticities) log_warning(path + ": has no chromaticities attribute, taken as Rec.709");
    const glm::mat3 to_working = image::rgb_to_rec2020(file.chromaticities.value_or(image::kRec709));
    const bool convert = file.chromaticities != image::kRec2020;
    Picture picture{image::ImageF(file.pixels.width, file.pixels.height, 3), true};
    for (int y = 0; y < file.pixels.height; ++y)
        for (int x = 0; x < file.pixels.width; ++x) {
            const float* in = file.pixels.at(x, y);
            glm::vec3 value(in[channel[0]], in[channel[1]], in[channel[2]]);
            if (convert) value = to_working * value;
            for (int k = 0; k < 3; ++k) picture.pixels.at(x, y)[k] = value[k];
        }
    return picture;
}

Result<Picture> read_display(const std::string& path) {
    std::string damage;
    TRY(const image::Image8 file, image::read_ldr(path, &damage));
    if (!damage.empty()) log_warning(path + ": " + damage);
    Picture picture{image::ImageF(file.width, file.height, 3), false};
    for (int y = 0; y < file.height; ++y)
        for (int x = 0; x < file.width; ++x)
            for (int k = 0; k < 3; ++k)
                picture.pixels.at(x, y)[k] = static_cast<float>(file.at(x, y)[k]) / 255.0f;
    return picture;
}

Result<Picture> read_picture(const std::string& path) {
    const std::string ending = lower(std::filesystem::path(path).extension().string());
    if (ending == ".exr") return read_linear(path);
    if (ending == ".png" || ending == ".jpg" || ending == ".jpeg") return read_display(path);
    return Error{"is no picture that can be compared, expected .exr, .png or .jpg", path};
}

// The automatic exposure of render (shaders/relight/meter.comp), of every pixel.
double metered_ev100(const image::PicturePair& pair) {
    double sum = 0;
    double count = 0;
    for (std::size_t p = 0; p < pair.counts.size(); ++p) {
        if (!pair.takes_part(p)) continue;
        const float luminance = shared::luminance_of(pair.reference_at(p));
        if (luminance <= shared::kMeterFloor) continue;
        sum += std::log2(static_cast<double>(luminance));
        count += 1;
    }
    return (count > 0 ? sum / count : 0.0) + 3.0 + static_cast<double>(shared::kAutoBias);
}

image::FlipMap compare_linear(const image::PicturePair& pair, const CompareArguments& arguments,
                              Comparison& out) {
    image::FlipMap map = image::hdr_flip(pair, arguments.pixels_per_degree);
    const image::RelativeErrors errors = image::relative_errors(pair);
    out.ev100 = arguments.ev100 ? static_cast<double>(*arguments.ev100) : metered_ev100(pair);
    out.exposures = image::flip_exposures(pair);
    const float exposure = shared::exposure_of(static_cast<float>(*out.ev100));
    const double psnr = image::psnr_db(
        pair, [&](const glm::vec3& value) { return shared::develop(value, exposure, shared::kToneAgx); });
    const double psnr_p75 = image::psnr_db(pair, image::p75_curve(pair));
    out.metrics = {{"flip", map.mean},
                   {"flip_p99", map.p99},
                   {"flip_max", map.max},
                   {"relmse", errors.relmse},
                   {"relmse_trimmed", errors.relmse_trimmed},
                   {"psnr", psnr},
                   {"psnr_p75", psnr_p75},
                   {"bias", errors.bias},
                   {"max_error", errors.max_error},
                   {"p99_error", errors.p99_error}};
    return map;
}

// PSNR of the values as they are stored; FLIP of the light they stand for.
image::FlipMap compare_display(image::PicturePair pair, const CompareArguments& arguments, Comparison& out) {
    const double psnr = image::psnr_db(pair, [](const glm::vec3& value) { return value; });
    for (image::ImageF* picture : {&pair.test, &pair.reference})
        for (std::size_t k = 0; k < picture->samples.size(); k += 3) {
            float* value = picture->samples.data() + k;
            const glm::vec3 linear =
                image::rec709_to_rec2020({image::srgb_to_linear(value[0]), image::srgb_to_linear(value[1]),
                                          image::srgb_to_linear(value[2])});
            for (int c = 0; c < 3; ++c) value[c] = linear[c];
        }
    image::FlipMap map = image::ldr_flip(pair, arguments.pixels_per_degree);
    out.metrics = {{"flip", map.mean}, {"flip_p99", map.p99}, {"flip_max", map.max}, {"psnr", psnr}};
    return map;
}

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

// What the gates say, one sentence each; empty: all hold.
std::vector<std::string> failures(const Comparison& comparison, const std::vector<Gate>& gates) {
    std::vector<std::string> failed;
    for (const Gate& gate : gates) {
        const auto found = std::find_if(comparison.metrics.begin(), comparison.metrics.end(),
                                        [&](const Metric& metric) { return metric.name == gate.name; });
        if (found == comparison.metrics.end()) {
            failed.push_back(gate.name + " needs linear pictures (.exr)");
            continue;
        }
        const double value = gate.name == "bias" ? std::abs(found->value) : found->value;
        if (gate.is_minimum ? !(value >= gate.limit) : !(value <= gate.limit))
            failed.push_back(gate.name + " is " + number(found->value) + ", expected " +
                             (gate.is_minimum ? "at least " : "at most ") + number(gate.limit));
    }
    if (comparison.non_finite > 0)
        failed.push_back(std::to_string(comparison.non_finite) + " pixels are not finite numbers");
    return failed;
}

void print_json(const Comparison& comparison, const std::vector<std::string>& failed) {
    nlohmann::json all = {
        {"pixels", comparison.counted}, {"non_finite", comparison.non_finite}, {"failed", failed}};
    for (const Metric& metric : comparison.metrics) {
        nlohmann::json& entry = all[metric.name];
        if (std::isfinite(metric.value)) entry = metric.value; // JSON knows no infinity: null
    }
    if (comparison.ev100) all["ev"] = *comparison.ev100;
    if (comparison.exposures)
        all["flip_exposures"] = {{"first", comparison.exposures->first},
                                 {"last", comparison.exposures->last},
                                 {"count", comparison.exposures->count}};
    print_text("%s\n", all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

void print_table(const Comparison& comparison) {
    for (const Metric& metric : comparison.metrics)
        print_text("%-15s %s%s\n", metric.name.c_str(), number(metric.value).c_str(),
                   metric.name.starts_with("psnr") ? " dB" : "");
    if (comparison.ev100)
        print_text("%-15s %.3g\n", "ev", *comparison.ev100);
    else
        print_text("%-15s display pictures: relative errors and bias need linear ones (.exr)\n", "-");
    print_text("%-15s %zu\n", "pixels", comparison.counted);
    print_text("%-15s %zu\n", "non_finite", comparison.non_finite);
}

Result<std::vector<std::string>> compare(const CompareArguments& arguments, const std::vector<Gate>& gates,
                                         const std::vector<image::Circle>& circles) {
    TRY(Picture test, read_picture(arguments.test));
    TRY(Picture reference, read_picture(arguments.reference));
    if (test.linear != reference.linear)
        return Error{
            std::string("one is linear (.exr) and the other a display picture (.png, .jpg); expected two "
                        "of a kind"),
            arguments.test + ", " + arguments.reference};
    const bool linear = test.linear;
    if (!linear && arguments.ev100)
        log_warning("--ev changes nothing: display pictures are compared as stored");
    Result<image::PicturePair> pair =
        image::pair_up(std::move(test.pixels), std::move(reference.pixels), circles);
    if (!pair.ok()) return Error{pair.error().what, arguments.test + ", " + arguments.reference};
    Comparison comparison;
    comparison.counted = pair->counted;
    comparison.non_finite = pair->non_finite;
    const image::FlipMap map = linear ? compare_linear(*pair, arguments, comparison)
                                      : compare_display(*std::move(pair), arguments, comparison);
    if (!arguments.difference.empty())
        TRY_VOID(image::write_png(arguments.difference, image::flip_picture(map.errors)));
    std::vector<std::string> failed = failures(comparison, gates);
    if (arguments.json)
        print_json(comparison, failed);
    else if (!arguments.quiet)
        print_table(comparison);
    return failed;
}

int run_compare(const CompareArguments& arguments) {
    if (arguments.quiet) set_log_level(LogLevel::warning);
    std::vector<Gate> gates;
    std::vector<image::Circle> circles;
    const auto wrong_usage = [](const Error& error) {
        log_error(error.text());
        return 2;
    };
    for (const bool is_minimum : {false, true})
        for (const std::string& text : is_minimum ? arguments.min : arguments.max) {
            const Result<Gate> gate = parse_gate(text, is_minimum);
            if (!gate.ok()) return wrong_usage(gate.error());
            gates.push_back(*gate);
        }
    for (const std::string& text : arguments.masked_out) {
        const Result<image::Circle> circle = parse_circle(text);
        if (!circle.ok()) return wrong_usage(circle.error());
        circles.push_back(*circle);
    }
    if (!arguments.difference.empty() && !arguments.difference.ends_with(".png"))
        return wrong_usage({"the file must end in .png: " + arguments.difference, "--difference"});
    const Result<std::vector<std::string>> failed = compare(arguments, gates, circles);
    if (!failed.ok()) {
        log_error(failed.error().text());
        return 1;
    }
    for (const std::string& text : *failed) log_error(text);
    return failed->empty() ? 0 : 1;
}

} // namespace

void add_compare(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("compare", "how far a picture is from a reference, in numbers");
    const auto arguments = std::make_shared<CompareArguments>();
    command->add_option("A", arguments->test, "picture: .exr (linear), .png or .jpg")->required();
    command->add_option("B", arguments->reference, "reference of the same size and kind")->required();
    const std::string names = "flip, flip_p99, flip_max, relmse, relmse_trimmed, bias, max_error, p99_error";
    command->add_option("--max", arguments->max, "exit 1 when METRIC is more (may be repeated): " + names)
        ->type_name("METRIC=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--min", arguments->min, "exit 1 when METRIC is less: psnr, psnr_p75")
        ->type_name("METRIC=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    command
        ->add_option("--ev", arguments->ev100, "EV100 at which psnr develops .exr files; else metered from B")
        ->check(number_in(-20.0, 40.0));
    command->add_option("--difference", arguments->difference, "write the FLIP map as a picture")
        ->type_name("FILE.png");
    command->add_option("--ppd", arguments->pixels_per_degree, "pixels per degree of the viewer, for FLIP")
        ->check(number_in(kMinPixelsPerDegree, kMaxPixelsPerDegree))
        ->capture_default_str();
    command
        ->add_option("--mask-out", arguments->masked_out, "leave out a circle, in pixels (may be repeated)")
        ->type_name("X,Y,RADIUS")
        ->take_all()
        ->allow_extra_args(false);
    command->add_flag("--json", arguments->json, "print the figures as JSON");
    command->add_flag("--quiet", arguments->quiet, "print warnings and errors only");
    command->footer("Example: ghostlight compare frame.exr reference.exr --max flip=0.02 --min psnr=45");
    command->callback([arguments, &exit_code] { exit_code = run_compare(*arguments); });
}

} // namespace ghost::app
