// What is compared runs interleaved, in one process: A B C A B C ..., and a ratio is the median of the rounds' ratios, so
// that a machine which slows down for a while slows all of them down.
//
// x_over_y says how many times faster x is than y: y's time divided by x's, for the same work.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace twinlight::bench {

// One of the ways of doing the work that is compared.
struct Way {
    std::string name;
    std::function<void()> run;  // does it once, and returns when it is done (after glFinish, say)
    double items = 1;           // of work in a run: times are for one
};

enum class Clock {
    kProcess,  // this process's time on all processors: others who use the machine do not count
    kWall,     // where the work is another process's
};

struct Rounds {
    int count = 15;
    double least_seconds = 0.005;  // of one measurement: a shorter run is repeated within it
    Clock clock = Clock::kProcess;
};

struct Timed {
    std::string name;
    std::vector<double> seconds;  // an item, one for each round
    double median() const;
    double least() const;   // of a time that is compared with nothing: whoever else uses the machine can only add to it
    double spread() const;  // half of what lies between the quartiles, of the median
};

// How many times faster `fast` is than `slow`: both of one compare().
double times_faster(const Timed& fast, const Timed& slow);

// Where the results and what is recorded for them are: $TWINLIGHT_BUILD, which make bench sets, or "build".
std::string build_folder();

double median(std::vector<double> values);
double geometric_mean(const std::vector<double>& values);

// A ratio that must be reached: at least, or at most where less is better.
struct Bar {
    double value;
    bool at_most = false;
};

// What a run of `make bench` finds: printed as it is found, and kept for build/bench.json. A quick run only shows that every part
// runs: one round of one run each, and no bars.
class Results {
  public:
    // where: the processor, its instruction set and the driver, in words.
    Results(bool is_quick, std::string where) : is_quick_(is_quick), where_(std::move(where)) {}
    const std::string& where() const { return where_; }
    bool is_quick() const { return is_quick_; }

    // Runs each way once unmeasured, then all of them in turn. Prints a table; the last column is against the first way.
    std::vector<Timed> compare(std::string_view title, const std::vector<Way>& ways, const Rounds& rounds = {});
    void ratio(const std::string& name, double value, std::optional<Bar> bar = {});
    void remark(std::string_view text);  // a line, wrapped by nobody

    void print_ratios() const;
    std::string json() const;

  private:
    struct Ratio {
        std::string name;
        double value;
        std::optional<Bar> bar;
    };
    bool is_quick_;
    std::string where_;
    std::vector<Ratio> ratios_;
    std::map<std::string, double> seconds_;  // by "title: way"
};

// A part of the bench, chosen by BENCH=Regex. `const bool added = add_part("name", run);` at the scope of a file.
using Part = void (*)(Results&);
bool add_part(std::string name, Part run);
const std::map<std::string, Part>& parts();

}  // namespace twinlight::bench
