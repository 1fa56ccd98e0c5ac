/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts that a person chooses: cuts of the tree, what is done to them, and undo.
 */

#include "clouds.h"
#include "prepared_points.h"
#include "sanitizers.h"

#include <pcl_cid/core/part_session.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** All that can be asked of a session. */
struct PartState {
  std::shared_ptr<const Decomposition> decomposition;
  std::vector<ChosenPart> parts;

  explicit PartState(const PartSession& session)
  : decomposition(session.decomposition()), parts(session.parts())
  {
  }

  bool
  operator==(const PartState& other) const
  {
    const auto is_same = [](const ChosenPart& a, const ChosenPart& b) {
      return a.groups == b.groups && a.size == b.size && a.height == b.height &&
             a.splits == b.splits && a.dropped == b.dropped && a.exact == b.exact;
    };
    return decomposition == other.decomposition && std::equal(parts.begin(),
                                                              parts.end(),
                                                              other.parts.begin(),
                                                              other.parts.end(),
                                                              is_same);
  }
};

/** Each group is in one part, parts are in order, and sizes are those of the groups. */
void
expectConsistent(const PartSession& session)
{
  if (!session.decomposition()) {
    EXPECT_TRUE(session.parts().empty());
    return;
  }
  const MergeTree& tree = session.decomposition()->tree;
  std::set<int> seen;
  int last = -1;
  for (const ChosenPart& part : session.parts()) {
    EXPECT_GT(part.number(), last);
    last = part.number();
    EXPECT_TRUE(std::is_sorted(part.groups.begin(), part.groups.end()));
    std::size_t size = 0;
    for (const int group : part.groups) {
      EXPECT_TRUE(seen.insert(group).second) << "group " << group << " is in two parts";
      size += tree.groupSizes()[static_cast<std::size_t>(group)];
    }
    EXPECT_EQ(part.size, size);
    EXPECT_EQ(part.splits, part.groups.size() > 1);
    if (!part.splits) {
      EXPECT_FALSE(part.height);
    }
  }
  EXPECT_EQ(seen.size(), tree.numberOfGroups());
}

std::vector<int>
partOfGroups(const PartSession& session)
{
  std::vector<int> part_of(session.decomposition()->tree.numberOfGroups());
  int number = 0;
  for (const ChosenPart& part : session.parts()) {
    for (const int group : part.groups)
      part_of[static_cast<std::size_t>(group)] = number;
    ++number;
  }
  return part_of;
}

/** An action, possible or not. */
PartAction
randomPartAction(const PartSession& session, std::mt19937_64& random)
{
  const std::vector<ChosenPart> parts = session.parts();
  const auto below = [&](std::size_t end) {
    return static_cast<std::size_t>(random() % end);
  };
  const auto some_part = [&] {
    return parts.empty() || random() % 16 == 0 ? static_cast<int>(below(20)) - 1
                                               : parts[below(parts.size())].number();
  };
  switch (random() % 12) {
  case 0:
    return part_action::Decompose{below(14)};
  case 1:
    return part_action::Cut{below(12)};
  case 2:
  case 3:
  case 4:
    return part_action::Split{some_part()};
  case 5:
  case 6:
    return part_action::Join{some_part(), some_part()};
  case 7:
    return part_action::Drop{some_part()};
  case 8:
    return part_action::Keep{some_part()};
  case 9:
    return part_action::Exact{some_part(), random() % 2 == 0};
  case 10:
    return part_action::Undo{};
  default:
    return part_action::Redo{};
  }
}

TEST(PartSession, CutsAreThoseOfTheTree)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const PreparedScan::ConstPtr scan = prepared(cloud.points, plainSettings());
    PartSession session(scan);
    session.apply(part_action::Decompose{12});
    Grouping grouping(scan);
    grouping.propose(12);
    EXPECT_EQ(session.decomposition()->groups, grouping.groups());
    const MergeTree tree = mergeGroups(grouping);
    EXPECT_EQ(partOfGroups(session), tree.cutAtElbow());
    for (std::size_t parts = 1; parts <= tree.numberOfGroups(); ++parts) {
      session.apply(part_action::Cut{parts});
      EXPECT_EQ(partOfGroups(session), tree.cutAtParts(parts));
      expectConsistent(session);
    }
  }
}

TEST(PartSession, SplittingUndoesTheLastMerge)
{
  PartSession session(prepared(twoBoxes(800, 5), plainSettings()));
  session.apply(part_action::Decompose{16});
  const std::vector<MergeStep>& steps = session.decomposition()->tree.steps();
  session.apply(part_action::Cut{1});
  for (std::size_t parts = 2; parts <= steps.size() + 1; ++parts) {
    const MergeStep& merge = steps[steps.size() + 1 - parts];
    const std::vector<ChosenPart> before = session.parts();
    const auto whole = std::find_if(before.begin(), before.end(), [&](const auto& p) {
      return p.number() == merge.first;
    });
    ASSERT_NE(whole, before.end());
    EXPECT_EQ(whole->height, merge.height);
    session.apply(part_action::Split{merge.first});
    EXPECT_EQ(partOfGroups(session), session.decomposition()->tree.cutAtParts(parts));
  }
}

TEST(PartSession, IsConsistentWhateverHappens)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    PartSession session(prepared(cloud.points, plainSettings()));
    std::mt19937_64 random(5);
    std::vector<PartAction> done;
    for (int k = 0; k < (is_sanitized ? 30 : 150); ++k) {
      const PartState before(session);
      const PartAction action = randomPartAction(session, random);
      try {
        session.apply(action);
        done.push_back(action);
      }
      catch (const CIDException&) {
        EXPECT_TRUE(PartState(session) == before)
            << "a refused action changed something";
      }
      expectConsistent(session);
    }
    PartSession other(session.sharedScan());
    for (const PartAction& action : done)
      other.apply(action, {3, {}});
    EXPECT_EQ(other.undoable(), session.undoable());
    EXPECT_EQ(other.redoable(), session.redoable());
    PartState expected(session);
    PartState actual(other);
    if (expected.decomposition) {
      EXPECT_EQ(actual.decomposition->groups, expected.decomposition->groups);
    }
    expected.decomposition = actual.decomposition;
    EXPECT_TRUE(actual == expected);
  }
}

TEST(PartSession, TakesBackAndDoesAgainAllThatHappened)
{
  PartSession session(prepared(twoBoxes(600, 5), plainSettings()));
  std::mt19937_64 random(9);
  for (int k = 0; k < 80; ++k)
    try {
      session.apply(randomPartAction(session, random));
    }
    catch (const CIDException&) {
    }
  while (session.redoable() > 0)
    session.apply(part_action::Redo{});
  std::vector<PartState> states{PartState(session)};
  while (session.undoable() > 0) {
    session.apply(part_action::Undo{});
    states.emplace_back(session);
  }
  EXPECT_EQ(states.back().decomposition, nullptr);
  for (auto state = states.rbegin(); state != states.rend(); ++state) {
    EXPECT_TRUE(PartState(session) == *state);
    if (session.redoable() > 0)
      session.apply(part_action::Redo{});
  }
}

TEST(PartSession, TakesBackCutsOneAfterAnotherAsOneStep)
{
  PartSession session(prepared(twoBoxes(600, 5), plainSettings()));
  session.apply(part_action::Decompose{8});
  const PartState decomposed(session);
  for (const std::size_t parts : {8u, 5u, 3u})
    session.apply(part_action::Cut{parts});
  EXPECT_EQ(session.undoable(), 2u);
  session.apply(part_action::Undo{});
  EXPECT_TRUE(PartState(session) == decomposed);
  session.apply(part_action::Redo{});
  EXPECT_EQ(session.parts().size(), 3u);
  session.apply(part_action::Cut{2}); // a step of its own after what is no cut
  EXPECT_EQ(session.undoable(), 3u);
  session.apply(part_action::Undo{});
  EXPECT_EQ(session.parts().size(), 3u);
}

TEST(PartSession, KeepsMarksOfPartsThatStay)
{
  PartSession session(prepared(twoBoxes(600, 5), plainSettings()));
  session.apply(part_action::Decompose{8});
  session.apply(part_action::Cut{8});
  const MergeStep last = session.decomposition()->tree.steps().back();
  session.apply(part_action::Cut{2});
  session.apply(part_action::Drop{last.first});
  session.apply(part_action::Exact{last.second, true});
  session.apply(part_action::Split{last.first}); // or it is one group, and stays
  for (const ChosenPart& part : session.parts()) {
    EXPECT_EQ(part.dropped, part.number() != last.second);
    EXPECT_EQ(part.exact, part.number() == last.second);
  }
  session.apply(part_action::Cut{3});
  for (const ChosenPart& part : session.parts())
    if (part.number() == last.second && part.exact) {
      session.apply(part_action::Join{last.first, last.second});
      EXPECT_TRUE(session.parts().front().exact) << "one of the two was";
      EXPECT_FALSE(session.parts().front().dropped) << "one of the two was not";
      return;
    }
}

TEST(PartSession, SaysWhatIsNotPossible)
{
  PartSession session(prepared(twoBoxes(300, 5), plainSettings()));
  EXPECT_THROW(session.apply(part_action::Cut{1}), CIDException);
  EXPECT_THROW(session.apply(part_action::Split{0}), CIDException);
  EXPECT_THROW(session.apply(part_action::Undo{}), CIDException);
  EXPECT_THROW(session.apply(part_action::Redo{}), CIDException);
  EXPECT_THROW(session.apply(part_action::Decompose{0}), CIDException);
  session.apply(part_action::Decompose{4});
  EXPECT_THROW(session.apply(part_action::Cut{0}), CIDException);
  EXPECT_THROW(session.apply(part_action::Cut{5}), CIDException);
  session.apply(part_action::Cut{4});
  EXPECT_THROW(session.apply(part_action::Split{0}), CIDException);
  EXPECT_THROW(session.apply(part_action::Join{1, 1}), CIDException);
  EXPECT_THROW(session.apply(part_action::Join{1, 4}), CIDException);
  EXPECT_THROW(session.apply(part_action::Drop{-1}), CIDException);
  EXPECT_THROW(PartSession(nullptr), CIDException);
  EXPECT_THROW(PartSession(session.sharedScan(), {0}), CIDException);
  EXPECT_THROW(PartSession(session.sharedScan(), {}, 0), CIDException);
}

TEST(PartSession, GivesUpADecompositionAndChangesNothing)
{
  PartSession session(prepared(twoBoxes(2000, 5), plainSettings()));
  session.apply(part_action::Decompose{4});
  const PartState before(session);
  EXPECT_THROW(
      session.apply(part_action::Decompose{40}, {1, [](double) { return false; }}),
      CIDCancelled);
  EXPECT_TRUE(PartState(session) == before);
}

} // namespace
} // namespace pcl_cid::test
