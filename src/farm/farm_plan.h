#pragma once
// SPDX-License-Identifier: Apache-2.0
// A bake or film cut into tasks that any machine can do that sees the show's folder. PLAN is a folder in the
// show's cache, farm/ID: plan.json, which never changes; done/TASK.json, of which the first one wins;
// failed/TASK.txt; frames/; log/ and submitted.json of an engine. Beside it, farm/newest names the plan that
// was asked for last. What is done, the disk says, never an engine or a clock. Any thread; several processes
// and machines at once.

#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {
struct Show;
} // namespace ghost::scene

namespace ghost::app {

inline constexpr std::size_t kMostFarmTasks = 20000;

struct FarmTask {
    std::string name;               // for people: "frames 240 to 479"
    int stage = 0;                  // tasks of stage 1 begin when all of stage 0 are done
    std::vector<std::string> words; // added to those of the plan
    long first_frame = -1;          // of what it leaves in its folder, one part or pictures; else nothing
    long last_frame = -1;
};

struct FarmPlan {
    std::filesystem::path folder;   // of the plan itself
    std::string build;              // what the program is: all tasks must be done by the same
    std::string inputs;             // what the show is
    std::filesystem::path show;     // as it was named, absolute
    std::filesystem::path from;     // the folder that the words' names start at
    std::vector<std::string> words; // of the command without what is a task's own; [0] is its name
    std::filesystem::path out;      // of a film, absolute; "" for a bake
    std::string camera;             // whose passes a film shows; "": it is drawn live
    int fps = 0;
    std::vector<std::filesystem::path> also; // files beside the show: recording, looks
    std::vector<FarmTask> tasks;
    bool is_ours = false;    // this user made it here
    bool is_trusted = false; // this user says that it may be done, whoever made it

    bool is_film() const { return !out.empty(); }
    bool is_one_file() const { return out.extension() == ".mp4"; }                // else numbered pictures
    std::string part_name() const { return "part" + out.extension().string(); }   // of what is one file
    std::string result_name() const { return (is_film() ? out : show).string(); } // for messages
    std::filesystem::path picture_file(long number) const; // of numbered pictures, beside out
    std::filesystem::path done_file(std::size_t task) const;
    std::filesystem::path failed_file(std::size_t task) const;
    // What a whole result leaves behind: its film is written, its passes are in the manifest.
    std::filesystem::path result_file() const { return folder / "done" / "result.json"; }
};

struct FarmDone {
    std::string host;
    double seconds = 0;
    std::string passes;           // of a film's camera, as it was drawn from
    std::string folder;           // of what it left, in frames/
    bool lacks_something = false; // that the show asks for, like a fixture's file
    long pictures = 0;            // of a whole result of numbered ones
    std::map<std::string, std::pair<std::uintmax_t, std::uint32_t>> files; // size and CRC
};

// Of the program that runs, and of what encodes films.
Result<std::string> farm_build();
// "-00042"; more digits from 100,000 on.
std::string number_text(long number);
// Of all files that a show is made of, and these beside it; not of what is baked.
std::string farm_inputs(const scene::Show& show, const std::vector<std::filesystem::path>& also);

// Names its folder below the show's cache by all that it depends on, and writes it where it is not yet.
Result<void> store_plan(FarmPlan& plan, const scene::Show& show);
// The folder that .ghost is in, or that stands for it: from there no step to a plan follows a link.
std::filesystem::path home_of(const FarmPlan& plan);
// Its folders, reached so.
Result<void> make_plan_folders(const FarmPlan& plan);
// Files of ours in done or failed; pictures of tasks. No link is followed.
Result<void> forget_of_tasks(const FarmPlan& plan, const char* folder);
Result<void> remove_pictures(const FarmPlan& plan);
Result<FarmPlan> read_plan(const std::filesystem::path& folder);
// name: a plan's folder, or a show, whose newest plan it then is.
Result<FarmPlan> find_plan(const std::string& name);

// Nothing: it is not done, or what it made is no longer there in full size.
std::optional<FarmDone> done_of(const FarmPlan& plan, std::size_t task);
std::vector<std::size_t> missing_tasks(const FarmPlan& plan);
// First wins: false where somebody was faster.
Result<bool> store_done(const FarmPlan& plan, std::size_t task, const FarmDone& done);
Result<void> store_result(const FarmPlan& plan, const FarmDone& result);
// The film that the result is of still lies there, or the plan is of a bake.
bool has_result(const FarmPlan& plan);
// Of a whole result: something that the show asks for is not in it.
bool result_lacks_something(const FarmPlan& plan);
// The last line of why a task failed; "": it did not.
std::string failure_of(const FarmPlan& plan, std::size_t task);
// Error: the plan may have come with the show, from a stranger. What it would do is said.
Result<void> check_ours(const FarmPlan& plan);
std::string node_name(); // this machine's, or Slurm's word for it

} // namespace ghost::app
