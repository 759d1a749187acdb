// SPDX-License-Identifier: Apache-2.0
#include "diagnose/private/doctor_substitute.h"

#include "base/text.h"
#include "diagnose/private/doctor_patch.h"
#include "fixture/values.h"
#include "fixture_files/load_type.h"
#include "plots/plot_types.h"

#include "base/suggest.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace ghost::scene {
namespace {

constexpr std::size_t kMaxLetters = 120; // names come from outside
constexpr std::size_t kLoaded = 3;
constexpr double kOtherNumber = 0.85; // a 2500 where a 2000 was asked for
constexpr double kLengthWorth = 0.1;  // of a mode that fits the patch, in likeness
constexpr double kGdtfWorth =
    0.15; // of a GDTF, whose name also holds a revision, and which brings all its pictures along

double gdtf_worth(const std::string& name) {
    return lower(name).ends_with(".gdtf") ? kGdtfWorth : 0;
}

struct Word {
    std::string text;
    double weight = 0;
};

std::vector<Word> words_of(const std::string& name) {
    std::string small = lower(name.substr(0, kMaxLetters));
    for (const std::string_view ending : fixture::kTypeEndings)
        if (small.ends_with(ending)) small.resize(small.size() - ending.size());
    std::vector<Word> words;
    const auto kind = [](char c) {
        if (std::isdigit(static_cast<unsigned char>(c))) return 1;
        return std::isalpha(static_cast<unsigned char>(c)) || (static_cast<unsigned char>(c) & 0x80) ? 2 : 0;
    };
    int before = 0;
    for (const char c : small) {
        const int now = kind(c);
        if (now != 0 && now != before) words.push_back({});
        if (now != 0) words.back().text += c;
        before = now;
    }
    for (Word& word : words) {
        word.weight =
            static_cast<double>(std::max<std::size_t>(2, std::min<std::size_t>(8, word.text.size())));
        for (const char* dull : {"lighting", "light", "lights", "led", "professional", "fixture", "custom",
                                 "rev", "revision", "technology", "gmbh", "inc", "the", "mode", "instr"})
            if (word.text == dull) word.weight = 0.5;
    }
    return words;
}

// 2500 and 2000 are two fixtures, Spider and Spiider one.
double alike(const std::string& a, const std::string& b) {
    if (a == b) return 1;
    if (std::isdigit(static_cast<unsigned char>(a[0])) || std::isdigit(static_cast<unsigned char>(b[0])))
        return 0;
    const double longer = static_cast<double>(std::max(a.size(), b.size()));
    const double fraction = 1.0 - static_cast<double>(edit_distance(a, b)) / longer;
    return fraction >= 0.7 ? fraction : 0;
}

// "Vari-Lite" is "Varilite": two words of one name that are one of the other.
void join_words(std::vector<Word>& words, const std::vector<Word>& others) {
    for (std::size_t k = 0; k + 1 < words.size(); ++k)
        for (const Word& other : others)
            if (words[k].text + words[k + 1].text == other.text) {
                words[k] = other;
                words.erase(words.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                break;
            }
}

bool is_number(const Word& word) {
    return std::isdigit(static_cast<unsigned char>(word.text[0])) != 0;
}

int length_of(const fixture::Mode& mode) {
    return mode.footprint.empty() ? 0 : mode.footprint.front();
}

} // namespace

double likeness(const std::string& wanted, const std::string& offered) {
    std::vector<Word> first = words_of(wanted);
    std::vector<Word> second = words_of(offered);
    join_words(first, second);
    join_words(second, first);
    double all = 0;
    for (const Word& word : first) all += word.weight;
    for (const Word& word : second) all += word.weight;
    if (first.empty() || second.empty()) return 0;
    double shared = 0;
    bool other_number = false; // one that the other name has not
    std::vector<bool> used(second.size());
    for (const Word& word : first) {
        double best = 0;
        std::size_t at = second.size();
        for (std::size_t k = 0; k < second.size(); ++k)
            if (const double now = used[k] ? 0 : alike(word.text, second[k].text); now > best) {
                best = now;
                at = k;
            }
        if (at == second.size()) {
            other_number = other_number || is_number(word);
            continue;
        }
        used[at] = true;
        shared += best * (word.weight + second[at].weight);
    }
    bool has_number = false;
    for (std::size_t k = 0; k < second.size(); ++k)
        has_number = has_number || (!used[k] && is_number(second[k]));
    return shared / all * (other_number && has_number ? kOtherNumber : 1.0);
}

std::optional<Suggestion>
suggest_substitute(const WantedFixture& wanted, std::span<const std::string> names,
                   const std::function<std::shared_ptr<const fixture::Type>(std::size_t)>& load) {
    std::vector<std::pair<double, std::size_t>> ranked;
    for (std::size_t k = 0; k < names.size(); ++k)
        if (const double value = likeness(wanted.name, names[k]); value >= kLikeFixture)
            ranked.push_back({value, k});
    std::stable_sort(ranked.begin(), ranked.end(), [&](const auto& a, const auto& b) {
        return a.first + gdtf_worth(names[a.second]) > b.first + gdtf_worth(names[b.second]);
    });
    if (ranked.size() > kLoaded) ranked.resize(kLoaded);
    std::optional<Suggestion> best;
    for (const auto& [value, offer] : ranked) {
        const std::shared_ptr<const fixture::Type> type = load(offer);
        if (!type || type->modes.empty()) continue;
        Suggestion suggestion{offer, value, "", 0, false};
        int mode = nearest_mode(*type, wanted.mode);
        if (wanted.channels > 0 && length_of(type->modes[static_cast<std::size_t>(mode)]) != wanted.channels)
            if (const int fits = mode_of_length(*type, wanted.channels); fits >= 0) mode = fits;
        const fixture::Mode& chosen = type->modes[static_cast<std::size_t>(mode)];
        suggestion.mode = chosen.name;
        suggestion.channels = length_of(chosen);
        suggestion.by_length = wanted.channels > 0 && suggestion.channels == wanted.channels;
        const auto worth = [&](const Suggestion& of) {
            return of.likeness + (of.by_length ? kLengthWorth : 0) + gdtf_worth(names[of.offer]);
        };
        if (!best || worth(suggestion) > worth(*best)) best = suggestion;
    }
    return best;
}

} // namespace ghost::scene
