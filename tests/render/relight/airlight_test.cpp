// SPDX-License-Identifier: Apache-2.0
// Haze by the gate against the airlight integral in closed form (Pegoraro and Parker 2009: the integral over
// the angle that the ray is seen under from the lamp): a beam of even candela in haze that scatters without
// weakening, Henyey-Greenstein. There the integral is an elliptic one of the second kind, which the standard
// library has.
#include "support/likeness.h"
#include "support/test_view.h"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace ghost::render {
namespace {

using glm::dvec3;
using glm::vec3;

// The integral of (1 - g^2) / (4 pi (1 + g^2 - 2 g sin x)^1.5) over x, from -pi/2 on. sin x = -cos 2p makes
// the bracket (1 + g)^2 (1 - m sin^2 p), and that integral is one of E(p, m) (DLMF 19.4). g >= 0.
double phase_integral(double g, double x) {
    const double p = std::numbers::pi / 4 + x / 2;
    const double m = 4 * g / ((1 + g) * (1 + g));
    const double root = std::sqrt(1 - m * std::sin(p) * std::sin(p));
    const double integral = (std::ellint_2(std::sqrt(m), p) - m * std::sin(p) * std::cos(p) / root) / (1 - m);
    return (1 - g * g) / (4 * std::numbers::pi) * 2 * integral / std::pow(1 + g, 3);
}

// Over the angles from..to, where the light goes on at the angle pi/2 + x to the ray: the phase's cosine is
// -sin x.
double scattered(double g, double from, double to) {
    return g < 0 ? phase_integral(-g, to) - phase_integral(-g, from)
                 : phase_integral(g, -from) - phase_integral(g, -to);
}

struct Segment {
    double from = 0;
    double to = 0;
};

// Of the ray eye + t dir, t in 0..far, inside the cone beyond the lens.
Segment inside_cone(const shared::Light& light, const dvec3& eye, const dvec3& dir, double far) {
    const auto gate = [&](const dvec3& v) {
        return dvec3(glm::dot(v, dvec3(light.axis_u)), glm::dot(v, dvec3(light.axis_v)),
                     glm::dot(v, dvec3(light.axis_w)));
    };
    const dvec3 q = gate(eye - dvec3(light.position_m)), dq = gate(dir);
    const double k2 = std::pow(static_cast<double>(light.tan_field), 2);
    const double a = dq.x * dq.x + dq.y * dq.y - k2 * dq.z * dq.z;
    const double b = q.x * dq.x + q.y * dq.y - k2 * q.z * dq.z;
    const double c = q.x * q.x + q.y * q.y - k2 * q.z * q.z;
    std::vector<double> ends{0, far};
    const double lens = (static_cast<double>(light.lens_m) - q.z) / dq.z;
    ends.push_back(std::clamp(lens, 0.0, far));
    if (b * b > a * c)
        for (const double sign : {-1.0, 1.0})
            ends.push_back(std::clamp((-b + sign * std::sqrt(b * b - a * c)) / a, 0.0, far));
    std::sort(ends.begin(), ends.end());
    // A cone and a half space are convex: one part of the ray is inside.
    Segment inside{1, 0};
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const dvec3 middle = q + 0.5 * (ends[k - 1] + ends[k]) * dq;
        if (ends[k] <= ends[k - 1] || middle.z <= static_cast<double>(light.lens_m) ||
            middle.x * middle.x + middle.y * middle.y > k2 * middle.z * middle.z)
            continue;
        if (inside.from > inside.to) inside.from = ends[k - 1];
        inside.to = ends[k];
    }
    return inside;
}

image::ImageF closed_form(const scene::Passes& passes, const shared::Light& light, const shared::Haze& haze) {
    image::ImageF picture(passes.width, passes.height, 3);
    const dvec3 eye(eye_of(passes));
    for (int y = 0; y < passes.height; ++y)
        for (int x = 0; x < passes.width; ++x) {
            const dvec3 dir(ray_through(passes, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
            const glm::vec4 surface = passes.fragments[static_cast<std::size_t>(y * passes.width + x)];
            const double far = surface.w < 0 ? 60.0 : glm::length(dvec3(surface) - eye);
            const Segment lit = inside_cone(light, eye, dir, far);
            if (lit.to <= lit.from) continue;
            const dvec3 to_lamp = dvec3(light.position_m) - eye;
            const double nearest = glm::dot(to_lamp, dir);
            const double height = glm::length(to_lamp - nearest * dir);
            const double from = std::atan2(lit.from - nearest, height),
                         to = std::atan2(lit.to - nearest, height);
            const double back = haze.back_weight;
            const double fraction =
                (1 - back) * scattered(haze.forward_g, from, to) + back * scattered(haze.back_g, from, to);
            for (int c = 0; c < 3; ++c)
                picture.at(x, y)[c] = static_cast<float>(
                    static_cast<double>(light.intensity_cd[c] * haze.scattering_per_m) * fraction / height);
        }
    return picture;
}

shared::Light even_beam(const vec3& from, const vec3& to, float field_deg) {
    shared::Light light = aimed_light(from, to, field_deg, 4000);
    light.profile_scale = 0; // the same candela everywhere
    light.edge = 1e-4f;
    light.lens_radius_m = 0;
    light.iris_radius = 1;
    light.cut_radius = 1.1f; // beyond what the edge is blurred
    return light;
}

using Airlight = RelightTest;

TEST_F(Airlight, ThePhaseIntegralIsTheIntegral) {
    for (const double g : {-0.6, 0.0, 0.3, 0.77, 0.95})
        for (const double from : {-1.5, -0.4, 0.9}) {
            const double to = from + 0.6;
            constexpr int kSteps = 20000;
            double sum = 0;
            for (int k = 0; k < kSteps; ++k) {
                const double cosine = -std::sin(from + (k + 0.5) * (to - from) / kSteps);
                sum += (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
            }
            EXPECT_NEAR(scattered(g, from, to) / (sum * (to - from) / kSteps), 1, 1e-6) << g << " " << from;
        }
}

TEST_F(Airlight, OfAnEvenBeamIsTheClosedForm) {
    struct Case {
        const char* name;
        vec3 eye, target;
        float fov_deg;
        shared::Light light;
    };
    const vec3 house(0, -12, 3), stage(0, 4, 3);
    const Case cases[] = {
        {"across, 30 degrees", house, stage, 26, even_beam({-4, 2, 6}, {4, 2, 0.5f}, 30)},
        {"across, 8 degrees", house, stage, 26, even_beam({-4, 2, 6}, {4, 2, 0.5f}, 8)},
        {"into the camera", house, stage, 26, even_beam({1, 5, 6}, {0, -12, 3}, 20)},
        {"from inside the cone", house, stage, 26, even_beam({0, -16, 5}, {0, 4, 2.5f}, 30)},
        {"away from the camera", house, stage, 26, even_beam({2, -9, 5}, {-1, 6, 2}, 25)},
        {"from below", {2, -6, 1.5f}, {0, 4, 3.5f}, 50, even_beam({0, 3, 0}, {1, 3, 9}, 40)},
    };
    struct Medium {
        const char* name;
        shared::Haze haze;
    };
    const Medium media[] = {{"isotropic", {0, 0.02f, 0, 0, 0}},
                            {"forward", {0, 0.02f, 0.77f, 0, 0}},
                            {"two lobes", {0, 0.02f, 0.77f, -0.6f, 0.035f}}};
    for (const Case& one : cases)
        for (const Medium& medium : media) {
            SCOPED_TRACE(std::string(one.name) + ", " + medium.name);
            const scene::Passes passes =
                wall_passes(camera_at(one.eye, one.target, one.fov_deg, 64, 36), 6.0f);
            Settings settings;
            settings.haze = medium.haze;
            Relighter relighter(device(), passes, test_gobos(), 1, settings);
            relighter.draw({one.light});
            const image::ImageF gate = relighter.frame(),
                                expected = closed_form(passes, one.light, medium.haze);
            const Difference difference = compare(gate, expected);
            const double psnr_db = likeness(gate, expected).psnr_db;
            std::printf("%-22s %-10s bias %6.3f %%, tone-mapped PSNR %.1f dB\n", one.name, medium.name,
                        100 * difference.mean_bias, psnr_db);
            EXPECT_LT(std::abs(difference.mean_bias), 0.002);
            EXPECT_GE(psnr_db, 44.0); // one ray a pixel, and an edge without any blur
        }
}

} // namespace
} // namespace ghost::render
