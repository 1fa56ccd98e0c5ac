/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The one table of settings: name, default, range, unit, and a sentence for each.
 */

#pragma once

#include <pcl_cid/pcl_cid_export.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace pcl_cid {

/** \brief A setting that is a number. Its row feeds the check in the library, the
 *  option of a tool and its help, the report, and the table in doc/settings.md. */
template <typename Value>
struct NumberSetting {
  const char* group;       ///< the headline it is listed under
  const char* name;        ///< in the report; the option has "-" for "_"
  const char* title;       ///< in a message: "the <title> is 0"
  const char* placeholder; ///< in the help: "--name PLACEHOLDER"
  const char* unit;        ///< "metres", or "" for a plain number
  Value initial;           ///< the default
  Value least;
  Value most;
  const char* meaning; ///< one sentence, without its full stop
  /** What 0 means, as it follows "0": "for all"; null where it is a value like any
   *  other. With a meaning, it is allowed even where the range leaves it out. */
  const char* zero = nullptr;
  /** What the paper has, where that is not the default (of a tool, either). */
  std::optional<Value> in_paper = std::nullopt;

  /** \brief What the paper has. */
  constexpr Value
  paper() const
  {
    return in_paper.value_or(initial);
  }

  /** \brief Whether a value, of this type or a wider one, may be set. */
  template <typename Given>
  constexpr bool
  allows(Given value) const
  {
    return (value >= Given{least} && value <= Given{most}) ||
           (zero && value == Given{0});
  }

  /** \brief The row of an option that is left out to say what 0 says: without 0. */
  constexpr NumberSetting
  withoutZero() const
  {
    NumberSetting row = *this;
    row.zero = nullptr;
    return row;
  }
};

/** \brief "a whole number, 2 to 1048576", as it follows "it must be"; 0 is named where
 *  it is allowed beside the range. */
template <typename Value>
PCL_CID_EXPORT std::string
rangeOf(const NumberSetting<Value>& setting);

/** \brief Refuse a value that is out of its range.
 *  \throws CIDException "the <title> is <value>; it must be <range>" */
template <typename Value>
PCL_CID_EXPORT void
require(const NumberSetting<Value>& setting, Value value);

/** \brief The double that is written as a float is: 0.03, not 0.0299999993. */
PCL_CID_EXPORT double
asWritten(float value);

/** \brief A setting that is one of a few words. */
template <typename Value, std::size_t Count>
struct ChoiceSetting {
  struct Word {
    const char* word;
    Value value;
  };

  const char* group;
  const char* name;
  const char* placeholder;
  Value initial;
  std::array<Word, Count> words;
  const char* meaning;
  std::optional<Value> in_paper = std::nullopt; ///< where that is not the default

  /** \brief What the paper has. */
  constexpr Value
  paper() const
  {
    return in_paper.value_or(initial);
  }

  /** \brief The word for a value. */
  constexpr const char*
  wordOf(Value value) const
  {
    for (const Word& each : words)
      if (each.value == value)
        return each.word;
    return "";
  }

  /** \brief The value of a word; none when it is not one of them. */
  constexpr std::optional<Value>
  valueOf(std::string_view word) const
  {
    for (const Word& each : words)
      if (each.word == word)
        return each.value;
    return std::nullopt;
  }
};

/** \brief Whether CIDs are divided by the local spacing of the points (*ours*). */
enum class DensityWeight {
  automatic, ///< on where the spacing is uneven, off where it is even
  off,       ///< the paper
  on
};

/** \brief How the next seed is chosen. */
enum class SeedingRule {
  farthest, ///< the point with the largest CID (or cost) to its seed: the paper
  soft      ///< drawn with the 16th power of it as weight (*ours*): less drawn to noise
};

/** \brief Which groups Algorithm 2 begins with. */
enum class GroupRule {
  cid,    ///< the points with the smallest CID to each seed: the paper
  patches ///< smooth patches of the surface (*ours*): see SmoothPatches
};

/** \brief How parts are put together. */
enum class MergingRule {
  cid, ///< by group CID: Algorithm 2 of the paper
  hull ///< by the hull that comes out (*ours*): see fitHulls()
};

/** \brief The rows. */
namespace setting {

constexpr int any_number = std::numeric_limits<int>::max();
constexpr float any_length = std::numeric_limits<float>::max();
constexpr float above_zero = std::numeric_limits<float>::min();
/** Hulls are made in double; beyond this, cubes of lengths overflow. */
constexpr double longest = 1e15;
constexpr double shortest = 1e-15;

// A number: group, name, title, placeholder, unit, default, least, most, meaning, zero,
//   paper.
// A choice: group, name, placeholder, default, words, meaning, paper.
// clang-format off

inline constexpr NumberSetting<int> seeds{
    "Seeds", "seeds", "number of seeds", "K", "", 100, 1, any_number,
    "number of seeds"};

inline constexpr NumberSetting<float> coverage{
    "Seeds", "coverage", "coverage", "R", "metres", 0.0f, above_zero, any_length,
    "stop when every point is within this CID of its seed",
    "for no limit"};

inline constexpr NumberSetting<int> samples{
    "Seeds", "samples", "number of samples on a segment", "M", "", 100, 2, 1 << 20,
    "samples on a segment (Eq. 2)"};

inline constexpr NumberSetting<int> subsample{
    "Seeds", "subsample", "subsample", "N", "", 0, 0, any_number,
    "work on a random draw of N points, which the others follow (the paper: 20000)",
    "for all"};

inline constexpr NumberSetting<std::uint64_t> random_seed{
    "Seeds", "random_seed", "random seed", "S", "", 0, 0,
    std::numeric_limits<std::uint64_t>::max(),
    "of every random draw"};

inline constexpr NumberSetting<int> start_index{
    "Seeds", "start_index", "start index", "I", "", 0, 0, any_number,
    "first seed, a point of the input, instead of a random one"};

inline constexpr ChoiceSetting<DensityWeight, 3> density{
    "Raw scans", "density", "WHEN", DensityWeight::automatic,
    {{{"auto", DensityWeight::automatic},
      {"off", DensityWeight::off},
      {"on", DensityWeight::on}}},
    "divide CIDs by the local spacing of the points: auto (where it is uneven), off "
    "(the paper) or on",
    DensityWeight::off};

inline constexpr NumberSetting<float> density_power{
    "Raw scans", "density_power", "density power", "P", "", 1.0f, 0.0f, 4.0f,
    "power of the spacing that CIDs are divided by"};

inline constexpr NumberSetting<int> isolated_neighbors{
    "Raw scans", "isolated_neighbors", "least number of near neighbors", "N", "",
    4, 0, 8,
    "points with fewer others near them do not become seeds",
    "to let all become seeds",
    0};

inline constexpr ChoiceSetting<SeedingRule, 2> seeding{
    "Raw scans", "seeding", "RULE", SeedingRule::farthest,
    {{{"farthest", SeedingRule::farthest}, {"soft", SeedingRule::soft}}},
    "the next seed: farthest (the paper), or soft: drawn, the farther the likelier"};

inline constexpr NumberSetting<float> color{
    "Raw scans", "color", "color weight", "LAMBDA", "metres", 0.0f, 0.0f, any_length,
    "what a unit of difference in CIE L*a*b* adds to a CID"};

inline constexpr NumberSetting<float> normals{
    "Raw scans", "normals", "normal weight", "LAMBDA", "metres", 0.03f, 0.0f, any_length,
    "what a right angle of the surfaces at two points adds to their CID",
    nullptr, 0.0f};

inline constexpr ChoiceSetting<bool, 2> connected{
    "Raw scans", "connected", "WHEN", true,
    {{{"on", true}, {"off", false}}},
    "a piece of a group that does not hang together with its seed goes to a group next "
    "to it: on or off (the paper)",
    false};

inline constexpr ChoiceSetting<bool, 2> blind_spot{
    "Raw scans", "blind_spot", "WHEN", true,
    {{{"auto", true}, {"off", false}}},
    "the floor that a scanner hides from itself is a part of the surface: auto "
    "(where there is a hole under the viewpoint) or off",
    false};

inline constexpr ChoiceSetting<bool, 2> clean_up{
    "Labels", "clean_up", "WHEN", false,
    {{{"off", false}, {"on", true}}},
    "mend ragged boundaries between labels: on or off (the paper)"};

// Where to cut the tree: without any of these three, the elbow decides; their defaults
// stand for no value.
inline constexpr NumberSetting<int> parts{
    "Parts", "parts", "number of parts", "K", "", 30, 1, any_number,
    "merge groups until this many parts remain"};

inline constexpr NumberSetting<double> threshold{
    "Parts", "threshold", "merge threshold", "R", "metres", 0.0, 0.0, longest,
    "merge while the smallest group CID is at most this"};

inline constexpr NumberSetting<int> merges{
    "Parts", "merges", "number of merges", "T", "", 0, 0, any_number,
    "merge this many times"};

inline constexpr ChoiceSetting<GroupRule, 2> groups{
    "Parts", "groups", "RULE", GroupRule::cid,
    {{{"cid", GroupRule::cid}, {"patches", GroupRule::patches}}},
    "merge the groups of seeds (cid, the paper), or smooth patches of the surface, as "
    "many as --seeds says (patches)"};

inline constexpr NumberSetting<int> group_samples{
    "Parts", "group_samples", "group sample size", "G", "", 32, 1, 1 << 20,
    "points drawn from each group; its group CIDs are means of so many pairs"};

// A tool has another default where nothing is asked about groups, hence the paper's here.
inline constexpr ChoiceSetting<MergingRule, 2> merging{
    "Parts", "merging", "RULE", MergingRule::cid,
    {{{"cid", MergingRule::cid}, {"hull", MergingRule::hull}}},
    "join parts by their group CID (cid, the paper), or so that hulls leave free space "
    "free (hull)",
    MergingRule::cid};

inline constexpr NumberSetting<double> max_error{
    "Parts", "max_error", "bound on the error of hulls", "T", "metres", 0.1, shortest,
    longest,
    "with --merging hull: no hull holds a place farther from the scan than this"};

inline constexpr NumberSetting<double> robot_radius{
    "Parts", "robot_radius", "radius of the robot", "R", "metres", 0.15, 0.0, longest,
    "with --merging hull: places count that are at least this far from the scan"};

inline constexpr NumberSetting<int> min_points{
    "Parts", "min_points", "least number of points of a part", "N", "", 1, 1,
    any_number,
    "drop parts of fewer points; no hull covers those"};

inline constexpr NumberSetting<double> min_thickness{
    "Hulls", "min_thickness", "least thickness of a hull", "R", "metres", 0.005,
    shortest, longest,
    "thicken parts that are thinner than this"};

inline constexpr NumberSetting<int> max_vertices{
    "Hulls", "max_vertices", "largest number of vertices", "N", "", 0, 4, any_number,
    "most vertices of a hull; larger ones are simplified outward",
    "for any number"};

inline constexpr NumberSetting<double> padding{
    "Hulls", "padding", "padding", "R", "metres", 0.0, 0.0, longest,
    "grow hulls outward by this"};

inline constexpr NumberSetting<double> trim_distance{
    "Hulls", "trim_distance", "trim distance", "R", "metres", 0.0, 0.0, longest,
    "leave stray points out of hulls: clusters that are farther from the bulk of "
    "their part than this",
    "for none"};

inline constexpr NumberSetting<double> free_distance{
    "Hulls", "free_distance", "free distance", "R", "metres", 0.05, shortest, longest,
    "space that is farther than this from the scan counts as free"};

inline constexpr NumberSetting<double> scale{
    "Run", "scale", "scale", "S", "metres", 1.0, shortest, longest,
    "length of a unit of the input's coordinates; 0.001 for millimetres"};

inline constexpr NumberSetting<double> mesh_spacing{
    "Run", "mesh_spacing", "spacing of samples", "R", "units of the input", 0.0, shortest,
    longest,
    "how far apart points are that are laid over the surface of a mesh (OBJ, STL, OFF, "
    "and with this option PLY)",
    "for about 200,000 points"};

inline constexpr NumberSetting<unsigned int> threads{
    "Run", "threads", "number of threads", "T", "", 0, 0, 1024,
    "number of threads, which never changes a result",
    "for all"};

// clang-format on

} // namespace setting

/** \brief Call \a visit with every row of the table, in its order. */
template <typename Visitor>
void
forEachSetting(Visitor&& visit)
{
  const auto visit_all = [&](const auto&... rows) { (visit(rows), ...); };
  visit_all(setting::seeds,
            setting::coverage,
            setting::samples,
            setting::subsample,
            setting::random_seed,
            setting::start_index,
            setting::density,
            setting::density_power,
            setting::isolated_neighbors,
            setting::seeding,
            setting::color,
            setting::normals,
            setting::connected,
            setting::blind_spot,
            setting::clean_up,
            setting::parts,
            setting::threshold,
            setting::merges,
            setting::groups,
            setting::group_samples,
            setting::merging,
            setting::max_error,
            setting::robot_radius,
            setting::min_points,
            setting::min_thickness,
            setting::max_vertices,
            setting::padding,
            setting::trim_distance,
            setting::free_distance,
            setting::scale,
            setting::mesh_spacing,
            setting::threads);
}

} // namespace pcl_cid
