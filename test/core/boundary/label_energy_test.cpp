/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Alpha expansion against all labelings.
 */

#include "boundary/label_energy.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Labels = std::vector<std::uint32_t>;

/** Sites that may have some of the labels 1 to \a labels. */
LabelEnergy
randomEnergy(std::mt19937_64& random,
             std::size_t sites,
             std::uint32_t labels,
             std::uint64_t most)
{
  LabelEnergy energy;
  for (std::size_t i = 0; i < sites; ++i) {
    std::vector<LabelEnergy::Choice> choices;
    for (std::uint32_t label = 1; label <= labels; ++label)
      if (random() % 4 != 0)
        choices.push_back({label, static_cast<std::int64_t>(random() % (most + 1))});
    if (choices.empty())
      choices.push_back({1, 0});
    energy.choices.push_back(choices);
  }
  for (std::size_t i = 0; i < sites; ++i)
    for (std::size_t k = i + 1; k < sites; ++k)
      if (random() % 3 == 0)
        energy.links.push_back({i, k, static_cast<std::int64_t>(1 + random() % most)});
  return energy;
}

Labels
randomLabels(std::mt19937_64& random, const LabelEnergy& energy)
{
  Labels labels;
  for (const auto& choices : energy.choices)
    labels.push_back(choices[random() % choices.size()].label);
  return labels;
}

/** The energy by its definition. */
std::int64_t
literalEnergy(const LabelEnergy& energy, const Labels& labels)
{
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (const LabelEnergy::Choice& choice : energy.choices[i])
      if (choice.label == labels[i])
        sum += choice.cost;
  for (const LabelEnergy::Link& link : energy.links)
    sum += labels[link.first] != labels[link.second] ? 2 * link.half : 0;
  return sum;
}

/** Visit all labelings of the sites from a number on. */
void
visitLabelings(const std::vector<std::vector<std::uint32_t>>& options,
               Labels& labels,
               std::size_t site,
               const std::function<void()>& visit)
{
  if (site == options.size())
    return visit();
  for (const std::uint32_t label : options[site]) {
    labels[site] = label;
    visitLabelings(options, labels, site + 1, visit);
  }
}

/** All labelings of an energy. */
std::vector<std::vector<std::uint32_t>>
allOptions(const LabelEnergy& energy)
{
  std::vector<std::vector<std::uint32_t>> options;
  for (const auto& choices : energy.choices) {
    options.emplace_back();
    for (const LabelEnergy::Choice& choice : choices)
      options.back().push_back(choice.label);
  }
  return options;
}

/** The labelings of one expansion move. */
std::vector<std::vector<std::uint32_t>>
movesTo(std::uint32_t alpha, const LabelEnergy& energy, const Labels& labels)
{
  std::vector<std::vector<std::uint32_t>> options;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    options.push_back({labels[i]});
    for (const LabelEnergy::Choice& choice : energy.choices[i])
      if (choice.label == alpha && alpha != labels[i])
        options.back().push_back(alpha);
  }
  return options;
}

std::int64_t
leastOf(const LabelEnergy& energy,
        const std::vector<std::vector<std::uint32_t>>& options)
{
  Labels labels(options.size());
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  visitLabelings(options, labels, 0, [&] {
    least = std::min(least, literalEnergy(energy, labels));
  });
  return least;
}

TEST(LabelEnergy, IsTheSumOfItsTerms)
{
  std::mt19937_64 random(2);
  for (int round = 0; round < 100; ++round) {
    const LabelEnergy energy = randomEnergy(random, 8, 4, 100);
    const Labels labels = randomLabels(random, energy);
    EXPECT_EQ(energyOf(energy, labels), literalEnergy(energy, labels));
  }
}

TEST(LabelEnergy, TwoLabelsReachTheMinimum)
{
  std::mt19937_64 random(3);
  for (int round = 0; round < 500; ++round) {
    const LabelEnergy energy =
        randomEnergy(random, 1 + random() % 10, 2, round % 2 ? 3 : 1000);
    const Labels lowered = lowerEnergy(energy, randomLabels(random, energy), 20);
    ASSERT_EQ(literalEnergy(energy, lowered), leastOf(energy, allOptions(energy)))
        << round;
  }
}

TEST(LabelEnergy, NoExpansionLowersTheResult)
{
  std::mt19937_64 random(4);
  for (int round = 0; round < 500; ++round) {
    const LabelEnergy energy =
        randomEnergy(random, 1 + random() % 8, 4, round % 2 ? 3 : 1000);
    const Labels start = randomLabels(random, energy);
    const Labels lowered = lowerEnergy(energy, start, 20);
    const std::int64_t reached = literalEnergy(energy, lowered);
    ASSERT_LE(reached, literalEnergy(energy, start)) << round;
    ASSERT_LE(reached, 2 * leastOf(energy, allOptions(energy))) << round;
    for (std::uint32_t alpha = 1; alpha <= 4; ++alpha)
      ASSERT_EQ(leastOf(energy, movesTo(alpha, energy, lowered)), reached) << round;
    ASSERT_EQ(lowerEnergy(energy, lowered, 20), lowered) << round;
  }
}

/** Each label in turn, again and again, by looking at all expansions: the smallest of
 *  equally good ones. */
Labels
loweredByAllMoves(const LabelEnergy& energy, Labels labels)
{
  for (bool any = true; any;) {
    any = false;
    for (std::uint32_t alpha = 1; alpha <= 4; ++alpha) {
      Labels moved(labels.size());
      Labels best = labels;
      std::ptrdiff_t fewest = 0;
      visitLabelings(movesTo(alpha, energy, labels), moved, 0, [&] {
        std::ptrdiff_t changed = 0;
        for (std::size_t i = 0; i < labels.size(); ++i)
          changed += moved[i] != labels[i];
        const std::int64_t gain =
            literalEnergy(energy, best) - literalEnergy(energy, moved);
        if (gain > 0 || (gain == 0 && changed < fewest)) {
          best = moved;
          fewest = changed;
        }
      });
      any = any || best != labels;
      labels = best;
    }
  }
  return labels;
}

TEST(LabelEnergy, FollowsTheDefinitionMoveByMove)
{
  std::mt19937_64 random(5);
  for (int round = 0; round < 300; ++round) {
    const LabelEnergy energy = randomEnergy(random, 1 + random() % 7, 4, 3);
    const Labels start = randomLabels(random, energy);
    ASSERT_EQ(lowerEnergy(energy, start, 1000), loweredByAllMoves(energy, start))
        << round;
  }
}

TEST(LabelEnergy, WithoutCyclesNothingChanges)
{
  std::mt19937_64 random(6);
  const LabelEnergy energy = randomEnergy(random, 8, 3, 10);
  const Labels start = randomLabels(random, energy);
  EXPECT_EQ(lowerEnergy(energy, start, 0), start);
  EXPECT_TRUE(lowerEnergy({}, {}, 20).empty());
}

} // namespace
} // namespace pcl_cid::test
