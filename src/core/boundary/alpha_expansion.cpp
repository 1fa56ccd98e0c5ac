/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Alpha expansion: the labels of an energy, lowered by minimum cuts.
 */

#include "label_energy.h"
#include "min_cut.h"

#include <algorithm>
#include <utility>

namespace pcl_cid {
namespace {

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

const LabelEnergy::Choice&
choiceOf(const std::vector<LabelEnergy::Choice>& choices, std::uint32_t label)
{
  return *std::lower_bound(
      choices.begin(), choices.end(), label, [](const auto& choice, std::uint32_t l) {
        return choice.label < l;
      });
}

/** Labels of the sites of an energy, and which of them may gain sites. */
class Expansion {
public:
  Expansion(const LabelEnergy& energy, std::vector<std::uint32_t> labels)
  : energy_(energy), labels_(std::move(labels)), node_(labels_.size(), nowhere)
  {
    collectLabels();
    collectLinks();
  }

  /** Try every label that may gain sites, once.
   *  \return whether one did */
  bool
  cycle()
  {
    bool any = false;
    for (std::size_t k = 0; k < alphas_.size(); ++k)
      if (std::exchange(may_gain_[k], std::uint8_t{0}))
        any = expand(k) || any;
    return any;
  }

  std::vector<std::uint32_t>
  takeLabels()
  {
    return std::move(labels_);
  }

private:
  struct End {
    std::size_t site;
    std::int64_t half;
  };

  void
  collectLabels()
  {
    for (const auto& choices : energy_.choices)
      for (const LabelEnergy::Choice& choice : choices)
        alphas_.push_back(choice.label);
    std::sort(alphas_.begin(), alphas_.end());
    alphas_.erase(std::unique(alphas_.begin(), alphas_.end()), alphas_.end());
    may_gain_.assign(alphas_.size(), 1);
    takers_.resize(alphas_.size());
    for (std::size_t i = 0; i < energy_.choices.size(); ++i)
      for (const LabelEnergy::Choice& choice : energy_.choices[i])
        takers_[numberOf(choice.label)].push_back(i);
  }

  void
  collectLinks()
  {
    first_end_.assign(labels_.size() + 1, 0);
    for (const LabelEnergy::Link& link : energy_.links) {
      ++first_end_[link.first];
      ++first_end_[link.second];
    }
    std::size_t ends = 0;
    for (std::size_t& first : first_end_)
      ends += std::exchange(first, ends);
    ends_.resize(ends);
    std::vector<std::size_t> next = first_end_;
    for (const LabelEnergy::Link& link : energy_.links) {
      ends_[next[link.first]++] = {link.second, link.half};
      ends_[next[link.second]++] = {link.first, link.half};
    }
  }

  std::size_t
  numberOf(std::uint32_t label) const
  {
    return static_cast<std::size_t>(
        std::lower_bound(alphas_.begin(), alphas_.end(), label) - alphas_.begin());
  }

  /** Visit the sites that are linked with one. */
  template <typename Visit>
  void
  visitLinked(std::size_t site, const Visit& visit) const
  {
    for (std::size_t k = first_end_[site]; k < first_end_[site + 1]; ++k)
      visit(ends_[k].site, ends_[k].half);
  }

  /** The best set of sites takes a label.
   *  \return whether there is one that lowers the energy */
  bool
  expand(std::size_t k)
  {
    std::vector<std::size_t> sites;
    for (const std::size_t site : takers_[k])
      if (labels_[site] != alphas_[k]) {
        node_[site] = sites.size();
        sites.push_back(site);
      }
    const CutGraph graph = graphOf(alphas_[k], sites);
    for (const std::size_t site : sites)
      node_[site] = nowhere;
    const bool any_gains = std::any_of(graph.from_source.begin(),
                                       graph.from_source.end(),
                                       [](auto gain) { return gain > 0; });
    return any_gains && take(k, sites, smallestSourceSide(graph));
  }

  /** The side of the source takes the label: the cut is what that costs. Two sites with
   *  different labels pay in each case but one, when both take it: that is half of the
   *  price on an edge, less half for each of them that takes it. */
  CutGraph
  graphOf(std::uint32_t alpha, const std::vector<std::size_t>& sites) const
  {
    CutGraph graph;
    graph.from_source.resize(sites.size());
    for (std::size_t n = 0; n < sites.size(); ++n) {
      const std::size_t site = sites[n];
      const std::uint32_t label = labels_[site];
      const auto& choices = energy_.choices[site];
      std::int64_t gain = choiceOf(choices, label).cost - choiceOf(choices, alpha).cost;
      visitLinked(site, [&](std::size_t other, std::int64_t half) {
        const bool differs = labels_[other] != label;
        if (node_[other] == nowhere)
          gain += 2 * half * (int{differs} - int{labels_[other] != alpha});
        else if (differs)
          gain += half;
        if (node_[other] != nowhere && n < node_[other])
          graph.edges.push_back({n, node_[other], differs ? half : 2 * half});
      });
      graph.from_source[n] = gain;
    }
    return graph;
  }

  bool
  take(std::size_t k,
       const std::vector<std::size_t>& sites,
       const std::vector<bool>& takes)
  {
    bool any = false;
    for (std::size_t n = 0; n < sites.size(); ++n)
      if (takes[n]) {
        labels_[sites[n]] = alphas_[k];
        touch(sites[n]);
        visitLinked(sites[n], [&](std::size_t other, std::int64_t) { touch(other); });
        any = true;
      }
    may_gain_[k] = 0; // it has just taken all that it can
    return any;
  }

  /** Something has changed at a site: all of its labels may gain it. */
  void
  touch(std::size_t site)
  {
    for (const LabelEnergy::Choice& choice : energy_.choices[site])
      may_gain_[numberOf(choice.label)] = 1;
  }

  const LabelEnergy& energy_;
  std::vector<std::uint32_t> labels_;
  std::vector<std::uint32_t> alphas_;            ///< all labels, ascending
  std::vector<std::uint8_t> may_gain_;           ///< by number in alphas_, as takers_
  std::vector<std::vector<std::size_t>> takers_; ///< sites that may have it
  std::vector<std::size_t> first_end_;           ///< of each site, and the end of all
  std::vector<End> ends_;
  std::vector<std::size_t> node_; ///< of each site in the graph that is made
};

} // namespace

std::int64_t
energyOf(const LabelEnergy& energy, const std::vector<std::uint32_t>& labels)
{
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    sum += choiceOf(energy.choices[i], labels[i]).cost;
  for (const LabelEnergy::Link& link : energy.links)
    if (labels[link.first] != labels[link.second])
      sum += 2 * link.half;
  return sum;
}

std::vector<std::uint32_t>
lowerEnergy(const LabelEnergy& energy,
            std::vector<std::uint32_t> labels,
            int most_cycles)
{
  Expansion expansion(energy, std::move(labels));
  for (int cycle = 0; cycle < most_cycles && expansion.cycle(); ++cycle)
    ;
  return expansion.takeLabels();
}

} // namespace pcl_cid
