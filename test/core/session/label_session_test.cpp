/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Sessions: their state from its definition, undo, and what is refused.
 */

#include "clouds.h"
#include "prepared_points.h"
#include "random_actions.h"
#include "sanitizers.h"
#include "session_state.h"

#include <pcl_cid/core/label_session.h>
#include <pcl_cid/exceptions.h>

#include <map>
#include <numeric>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

PreparedScan::ConstPtr
connectedScan(const Points& points)
{
  PreparationSettings settings = plainSettings();
  settings.connected = true;
  return prepared(points, settings);
}

/** What every point would have if its seeds had been given at once. */
void
expectFromScratch(const LabelSession& session)
{
  const SessionState state(session);
  Grouping grouping(session.grouping().sharedScan());
  pcl::Indices points;
  for (const SessionSeed& seed : state.seeds)
    points.push_back(seed.point);
  if (!points.empty())
    grouping.addSeeds(points);
  EXPECT_EQ(state.groups, grouping.groups());
  for (std::size_t i = 0; i < state.labels.size(); ++i)
    if (!state.painted[i] && state.groups[i] >= 0) {
      const auto group = static_cast<std::size_t>(state.groups[i]);
      EXPECT_EQ(state.labels[i], state.seeds[group].label.value_or(0));
    }
}

/** Points that an action has changed, by comparing. */
pcl::Indices
changedBetween(const SessionState& before, const SessionState& after)
{
  pcl::Indices changed;
  for (std::size_t i = 0; i < before.labels.size(); ++i)
    if (before.labels[i] != after.labels[i] || before.seedOf(i) != after.seedOf(i))
      changed.push_back(static_cast<pcl::index_t>(i));
  return changed;
}

std::uint32_t
labelAt(const LabelSession& session, std::size_t point)
{
  return session.labels()[point];
}

TEST(LabelSession, IsWhatItsSeedsWouldBeFromScratch)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    LabelSession session(connectedScan(cloud.points));
    std::mt19937_64 random(7);
    for (int step = 0; step < (is_sanitized ? 20 : 60); ++step) {
      const SessionState before(session);
      try {
        const pcl::Indices changed = session.apply(randomAction(session, random));
        EXPECT_EQ(changed, changedBetween(before, SessionState(session)));
      }
      catch (const CIDException&) {
        EXPECT_TRUE(SessionState(session) == before)
            << "a refused action changed something";
      }
      if (step % 10 == 9)
        expectFromScratch(session);
    }
  }
}

TEST(LabelSession, TakesBackAndDoesAgainAllThatHappened)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    LabelSession session(connectedScan(cloud.points));
    doRandomActions(is_sanitized ? 12 : 40, 3, session);
    while (session.redoable() > 0)
      session.apply(action::Redo{});
    std::vector<SessionState> states{SessionState(session)};
    while (session.undoable() > 0) {
      session.apply(action::Undo{});
      states.emplace_back(session);
    }
    EXPECT_TRUE(states.back() ==
                SessionState(LabelSession(connectedScan(cloud.points))));
    for (auto state = states.rbegin(); state != states.rend(); ++state) {
      EXPECT_TRUE(SessionState(session) == *state);
      if (session.redoable() > 0)
        session.apply(action::Redo{});
    }
    EXPECT_EQ(session.redoable(), 0u);
  }
}

TEST(LabelSession, EqualsAnotherOneThatDoesTheSameOnAnyNumberOfThreads)
{
  const PreparedScan::ConstPtr scan = connectedScan(twoBoxes(1500, 5));
  LabelSession session(scan);
  const std::vector<LabelAction> actions = doRandomActions(120, 11, session);
  for (const unsigned int threads : {1u, 2u, 3u, 8u}) {
    LabelSession other(scan);
    for (const LabelAction& action : actions)
      other.apply(action, onThreads(threads));
    EXPECT_TRUE(SessionState(other) == SessionState(session));
    EXPECT_EQ(other.undoable(), session.undoable());
    EXPECT_EQ(other.redoable(), session.redoable());
  }
}

TEST(LabelSession, LabelsQuestionsAndCorrects)
{
  LabelSession session(prepared(twoBoxes(400, 7)));
  session.apply(action::Propose{3});
  ASSERT_EQ(session.seeds().size(), 3u);
  EXPECT_EQ(session.nextQuestion()->left, 3u);
  EXPECT_EQ(session.labels(), std::vector<std::uint32_t>(400, 0));

  const Question question = *session.nextQuestion();
  session.apply(action::Label{question.seed, action::NewInstance{"box", "", {}}});
  EXPECT_EQ(std::count(session.labels().begin(), session.labels().end(), 1u),
            static_cast<std::ptrdiff_t>(question.size));
  EXPECT_EQ(session.nextQuestion()->left, 2u);
  EXPECT_NE(session.nextQuestion()->seed, question.seed);

  const pcl::index_t point = 5;
  const pcl::Indices preview = session.preview(point);
  session.apply(action::Click{{point}, action::NewInstance{"lid", "the red one", 9}});
  EXPECT_EQ(labelAt(session, 5), 9u);
  pcl::Indices taken;
  for (std::size_t i = 0; i < session.labels().size(); ++i)
    if (session.labels()[i] == 9)
      taken.push_back(static_cast<pcl::index_t>(i));
  EXPECT_EQ(taken, preview) << "a click did not take what was announced";

  session.apply(action::Click{{7}, action::NewInstance{"", "", {}}});
  EXPECT_EQ(session.instances().back().label, 10u) << "above all that there were";
}

TEST(LabelSession, PaintCoversWhatSeedsSay)
{
  LabelSession session(prepared(twoBoxes(300, 7)));
  session.apply(action::Click{{0}, action::NewInstance{"a", "", {}}});
  session.apply(action::Paint{{1, 2, 3}, action::NewInstance{"b", "", {}}});
  session.apply(action::Paint{{3, 4}, 0u});
  EXPECT_EQ(labelAt(session, 2), 2u);
  EXPECT_EQ(labelAt(session, 4), 0u);
  session.apply(action::Merge{1, 2});
  EXPECT_EQ(labelAt(session, 0), 2u);
  session.apply(action::Unpaint{{2, 4}});
  EXPECT_EQ(labelAt(session, 4), 2u);
  session.apply(action::Delete{2});
  EXPECT_EQ(session.seeds().size(), 0u);
  EXPECT_EQ(session.labels(), std::vector<std::uint32_t>(300, 0));
  EXPECT_TRUE(session.isPainted(3)) << "what was painted as none stays";
  EXPECT_FALSE(session.isPainted(1));
}

TEST(LabelSession, SettlesQuestionsInFavorOfTheAnswered)
{
  LabelSession session(prepared(twoBoxes(300, 7)));
  session.apply(action::Propose{6});
  session.apply(
      action::Label{session.nextQuestion()->seed, action::NewInstance{"a", "", {}}});
  session.apply(action::Settle{});
  EXPECT_EQ(session.labels(), std::vector<std::uint32_t>(300, 1));
  EXPECT_FALSE(session.nextQuestion());
  session.apply(action::Undo{});
  EXPECT_EQ(session.nextQuestion()->left, 5u);
  expectFromScratch(session);
}

TEST(LabelSession, QuestionsComeByTheSizeOfTheirGroups)
{
  LabelSession session(prepared(twoBoxes(500, 7)));
  session.apply(action::Propose{8});
  std::map<pcl::index_t, std::size_t> size;
  for (const pcl::index_t group : session.groups())
    ++size[session.seeds()[static_cast<std::size_t>(group)].point];
  std::optional<Question> question = session.nextQuestion();
  std::size_t before = question->size;
  std::size_t asked = 0;
  while (question) {
    EXPECT_EQ(question->size, size.at(question->seed));
    EXPECT_LE(question->size, before);
    before = question->size;
    ++asked;
    question = session.nextQuestion(question->seed);
  }
  EXPECT_EQ(asked, 8u);
}

TEST(LabelSession, MendsBoundariesButNotWhatWasPainted)
{
  LabelSession session(connectedScan(twoBoxes(600, 7)));
  session.apply(action::Propose{6});
  while (const std::optional<Question> question = session.nextQuestion())
    session.apply(action::Label{question->seed, action::NewInstance{"", "", {}}});
  session.apply(action::Paint{{10, 20, 30}, action::NewInstance{"", "", {}}});
  std::vector<std::uint32_t> label_of_seed;
  for (const SessionSeed& seed : session.seeds())
    label_of_seed.push_back(*seed.label);
  std::vector<std::uint32_t> expected =
      cleanBoundaries(session.grouping(), label_of_seed);
  for (const std::size_t i : {10, 20, 30})
    expected[i] = session.instances().back().label;
  EXPECT_EQ(session.cleanedLabels(), expected);
}

TEST(LabelSession, RefusesWhatIsNotPossible)
{
  LabelSession session(prepared(twoBoxes(100, 7)));
  session.apply(action::Click{{0}, action::NewInstance{"", "", {}}});
  const SessionState before(session);
  const std::vector<LabelAction> impossible = {
      action::Propose{0},
      action::Propose{101},
      action::Label{1, 1u},
      action::Label{0, 2u},
      action::Click{{}, 1u},
      action::Click{{100}, 1u},
      action::Click{{-1}, 1u},
      action::Click{{5, 5}, 1u},
      action::Click{{5}, 7u},
      action::Click{{5}, action::NewInstance{"", "", 1}},
      action::Click{{5}, action::NewInstance{"", "", 0}},
      action::Click{{5}, action::NewInstance{"", "", 0xFFFFFFFFu}},
      action::Remove{3},
      action::Paint{{}, 1u},
      action::Paint{{4, 3}, 1u},
      action::Paint{{3, 3}, 1u},
      action::Paint{{100}, 1u},
      action::Unpaint{{-1}},
      action::Edit{2, "", ""},
      action::Merge{1, 1},
      action::Merge{1, 2},
      action::Delete{0},
      action::Settle{},
      action::Redo{}};
  for (std::size_t k = 0; k < impossible.size(); ++k) {
    EXPECT_THROW(session.apply(impossible[k]), CIDException) << "action " << k;
    EXPECT_TRUE(SessionState(session) == before) << "action " << k;
  }
  EXPECT_EQ(session.undoable(), 1u);
  EXPECT_THROW(session.preview(100), CIDException);
  EXPECT_THROW(LabelSession(nullptr), CIDException);
}

TEST(LabelSession, ChangesNothingWhenCancelled)
{
  LabelSession session(prepared(twoBoxes(500, 7)));
  session.apply(action::Propose{5});
  const SessionState before(session);
  const ExecutionOptions cancelled{1, [](double) { return false; }};
  EXPECT_THROW(session.apply(action::Propose{5}, cancelled), CIDCancelled);
  EXPECT_THROW(
      session.apply(action::Click{{9}, action::NewInstance{"", "", {}}}, cancelled),
      CIDCancelled);
  EXPECT_TRUE(SessionState(session) == before);
  EXPECT_EQ(session.undoable(), 1u);
}

TEST(LabelSession, LeavesPointsThatAreNotSelectedAlone)
{
  RawScan raw = rawScan(twoBoxes(50, 7));
  raw.cloud_size = 53;
  for (pcl::index_t& point : raw.points.source)
    point += 2;
  PreparationSettings settings = plainSettings();
  settings.start_index = 2;
  LabelSession session(std::make_shared<PreparedScan>(std::move(raw), settings));
  session.apply(action::Click{{2}, action::NewInstance{"", "", {}}});
  EXPECT_EQ(labelAt(session, 0), 0u);
  EXPECT_EQ(labelAt(session, 51), 1u);
  EXPECT_EQ(labelAt(session, 52), 0u);
  for (const pcl::index_t point : {0, 1, 52}) {
    EXPECT_THROW(session.apply(action::Click{{point}, 1u}), CIDException);
    EXPECT_THROW(session.apply(action::Paint{{point}, 1u}), CIDException);
  }
}

} // namespace
} // namespace pcl_cid::test
