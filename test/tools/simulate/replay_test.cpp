/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_simulate --session: what the actions of a session brought.
 */

#include "random_actions.h"
#include "simulate_tool.h"

#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/core/annotation.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/session_file.h>

#include <fstream>

namespace pcl_cid::test {
namespace {

/** A session on the desk scan whose labels are not those of the truth. */
class Replay : public SimulateTool {
protected:
  Replay()
  {
    settings_.preparation.density = DensityWeight::off;
    settings_.grouping.samples = 40;
  }

  /** A session in which nothing was done. */
  LabelSession
  newSession() const
  {
    CIDLabelPropagation<pcl::PointXYZ> parameters;
    parameters.setDensityWeight(settings_.preparation.density);
    parameters.setNumberOfSamples(settings_.grouping.samples);
    parameters.setInputCloud(pointsOf(readCloud(truth_)).points);
    const PreparedScan::ConstPtr prepared = parameters.prepare();
    return LabelSession(prepared, parameters.getGroupingSettings());
  }

  void
  save(const std::vector<LabelAction>& actions) const
  {
    SessionFile file(session_, identityOf(readCloud(truth_)), settings_, true);
    for (const LabelAction& action : actions)
      file.append(action);
  }

  /** What a person does who knows what seeds are, and numbers instances from 1 up. */
  static void
  answerAll(LabelSession& session, std::vector<LabelAction>& actions)
  {
    for (const SessionSeed& seed : session.seeds())
      if (!seed.label) {
        const std::uint32_t instance =
            deskLabels()[static_cast<std::size_t>(seed.point)];
        actions.push_back(
            action::Label{seed.point, answerOf(std::to_string(instance), session)});
        session.apply(actions.back());
      }
  }

  Json
  scoresWith(Arguments more = {}) const
  {
    more.insert(more.begin(), {truth_, "--session", session_});
    return reportOf(more)["scans"][0]["scores"];
  }

  void
  expectReplayRefused(Arguments more, const Arguments& complaints, int code) const
  {
    more.insert(more.begin(), {truth_, "--session", session_});
    expectRefused(more, complaints, code);
  }

  SessionSettings settings_;
  std::string session_ = file("scan.session");

private:
  static action::Answer
  answerOf(const std::string& class_name, const LabelSession& session)
  {
    for (const NamedInstance& instance : session.instances())
      if (instance.class_name == class_name)
        return instance.label;
    return action::NewInstance{class_name, "", {}};
  }
};

TEST_F(Replay, TheSameClicksAreWorthWhatASimulatedAnnotatorsAre)
{
  LabelSession session = newSession();
  std::vector<LabelAction> actions;
  for (const std::size_t seeds : {4u, 5u}) {
    actions.push_back(action::Propose{seeds});
    session.apply(actions.back());
    answerAll(session, actions);
  }
  save(actions);
  const Json replayed = scoresWith();
  ASSERT_EQ(replayed.size(), 11u);
  const Json simulated =
      reportOf({truth_, "--clicks", "4,9", "--samples", "40", "--density", "off"});
  for (const Json& row : simulated["all"]) {
    const std::size_t clicks = row["clicks"];
    const Json& same = replayed[clicks == 4 ? 4 : 10];
    EXPECT_EQ(same["answers"], clicks);
    for (const auto& [name, value] : row.items())
      EXPECT_EQ(same[name], value) << name;
  }
}

TEST_F(Replay, TheLastScoreIsThatOfTheLabelsThatAreWritten)
{
  LabelSession session = newSession();
  save(doRandomActions(60, 3, session));
  for (const char* const clean_up : {"off", "on"}) {
    const Json scores = scoresWith({"--clean-up", clean_up});
    ASSERT_EQ(scores.size(), 60u);
    const Arguments segmenting{
        truth_, file("out.pcd"), "--session", session_, "--clean-up", clean_up};
    ASSERT_EQ(run("pcl_cid_segment", segmenting).exit_code, 0);
    const auto labels =
        valuesOf<std::uint32_t>(readCloud(file("out.pcd")).fields, "label");
    const AnnotationScore score =
        scoreAnnotations({pairedOverlaps(annotationOverlaps(labels, deskLabels()))});
    EXPECT_EQ(scores.back()["mean_iou"], score.mean_iou);
    EXPECT_EQ(scores.back()["recall50"], score.recall50);
    EXPECT_EQ(scores.back()["ap50"], score.ap50);
    const Arguments evaluating{file("out.pcd"),
                               truth_,
                               "--protocol",
                               "s3dis",
                               "--report",
                               file("evaluated.json")};
    ASSERT_EQ(run("pcl_cid_evaluate", evaluating).exit_code, 0);
    const Json evaluated = Json::parse(readText(file("evaluated.json")));
    for (const char* const figure : {"recall50", "recall75", "ap50"})
      EXPECT_EQ(scores.back()[figure], evaluated["mean"][figure]) << figure;
  }
}

TEST_F(Replay, EachActionIsToldWithWhatItBrought)
{
  LabelSession session = newSession();
  std::vector<LabelAction> actions{action::Propose{5}};
  session.apply(actions.back());
  answerAll(session, actions);
  actions.push_back(action::Click{{600, 601}, action::NewInstance{"a, \"b\"", "", {}}});
  const auto label = static_cast<std::uint32_t>(session.instances().size() + 1);
  actions.push_back(action::Undo{});
  actions.push_back(action::Redo{});
  actions.push_back(action::Paint{{5, 6, 9}, label});
  actions.push_back(action::Delete{label});
  save(actions);
  const Json scores = scoresWith();
  ASSERT_EQ(scores.size(), 11u);
  double before = 0.0;
  for (std::size_t k = 0; k < scores.size(); ++k) {
    EXPECT_EQ(scores[k]["line"], k + 2);
    const double iou = scores[k]["mean_iou"];
    EXPECT_EQ(scores[k]["gain_mean_iou"], iou - before);
    before = iou;
  }
  EXPECT_EQ(scores[0]["do"], "propose");
  EXPECT_EQ(scores[0]["mean_iou"], 0.0);
  EXPECT_EQ(scores[0]["point"], nullptr);
  EXPECT_EQ(scores[6]["do"], "click");
  EXPECT_EQ(scores[6]["point"], 600);
  EXPECT_EQ(scores[6]["points"], 2);
  EXPECT_EQ(scores[6]["label"], label);
  EXPECT_EQ(scores[6]["class"], "a, \"b\"");
  EXPECT_EQ(scores[6]["used"], 6);
  // What was taken back was said nevertheless.
  EXPECT_EQ(scores[7]["do"], "undo");
  EXPECT_EQ(scores[7]["mean_iou"], scores[5]["mean_iou"]);
  EXPECT_EQ(scores[7]["used"], 6);
  EXPECT_EQ(scores[8]["mean_iou"], scores[6]["mean_iou"]);
  EXPECT_EQ(scores[9]["answers"], 5);
  EXPECT_EQ(scores[9]["corrections"], 1);
  EXPECT_EQ(scores[9]["strokes"], 1);
  EXPECT_EQ(scores[9]["used"], 7);
  EXPECT_EQ(scores[10]["do"], "delete");
  EXPECT_EQ(scores[10]["class"], "a, \"b\"");
  EXPECT_EQ(scores[10]["mean_iou"], scores[5]["mean_iou"]);
}

TEST_F(Replay, TheTableBeginsWithTheColumnsOfASimulatedAnnotator)
{
  LabelSession session = newSession();
  save(doRandomActions(20, 5, session));
  const std::string csv =
      writtenBy({truth_, "--session", session_}, "--csv", "replayed.csv");
  EXPECT_EQ(csv.rfind("kind,name,instances,clicks,used,mean_iou,recall25,recall50,"
                      "recall75,ap50,line,do,point,points,label,class,answers,"
                      "corrections,strokes,gain_mean_iou,gain_recall25,gain_recall50,"
                      "gain_recall75,gain_ap50\nscan,truth,3,",
                      0),
            0u)
      << csv;
  const ToolRun printed = simulate({truth_, "--session", session_});
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_NE(printed.out.find("  line  do           point"), std::string::npos)
      << printed.out;
  EXPECT_NE(printed.out.find("\ndo         actions     gain  of each\n"),
            std::string::npos)
      << printed.out;
}

TEST_F(Replay, ThreadsChangeNothing)
{
  LabelSession session = newSession();
  save(doRandomActions(60, 7, session));
  for (const char* const clean_up : {"off", "on"}) {
    const Arguments arguments{truth_, "--session", session_, "--clean-up", clean_up};
    Arguments one = arguments;
    one.insert(one.end(), {"--threads", "1"});
    Arguments three = arguments;
    three.insert(three.end(), {"--threads", "3"});
    EXPECT_EQ(writtenBy(one, "--csv", "one.csv"),
              writtenBy(three, "--csv", "three.csv"));
  }
}

TEST_F(Replay, TheSessionDecidesAboutSettings)
{
  LabelSession session = newSession();
  save(doRandomActions(10, 5, session));
  for (const char* const option : {"--normals",
                                   "--samples",
                                   "--subsample",
                                   "--random-seed",
                                   "--start-index",
                                   "--clicks",
                                   "--proposals"})
    expectReplayRefused({option, "4"}, {"--session and " + std::string(option)}, 2);
  expectReplayRefused({"--protocol", "corrective"}, {"--session and --protocol"}, 2);
  expectReplayRefused({"--paper"}, {"--session and --paper"}, 2);
  expectReplayRefused({"--keep-zeros"}, {"--session and --keep-zeros"}, 2);
  expectReplayRefused({truth_}, {"--session is of one scan", "2"}, 2);
}

TEST_F(Replay, RefusesASessionThatIsNotOne)
{
  expectReplayRefused({}, {"scan.session: there is no session"}, 1);
  save({});
  expectReplayRefused({}, {"scan.session: nothing was done"}, 1);
  save({action::Propose{2}, action::Redo{}, action::Settle{}});
  expectReplayRefused({"--csv", file("out.csv")}, {"scan.session: line 3: "}, 1);
  save({action::Propose{2}});
  expectReplayRefused({"--csv", session_}, {"scan.session"}, 1);
  std::ofstream(session_, std::ios::app) << "torn in the\nmiddle\n";
  expectReplayRefused({"--csv", file("out.csv")}, {"line 3 is not JSON"}, 1);
}

TEST_F(Replay, DoesWhatCanBeDoneOfAnEndThatIsTorn)
{
  save({action::Propose{2}, action::Undo{}, action::Undo{}});
  std::ofstream(session_, std::ios::app) << "{\"do\": \"pro";
  EXPECT_EQ(scoresWith().size(), 2u);
}

TEST_F(Replay, RefusesAnotherScanAndOneWithoutTruth)
{
  save({action::Propose{2}});
  expectReplayRefused({"--truth-field", "instance"}, {"truth.pcd", "instance"}, 1);
  LabelledCloud other = readCloud(truth_);
  other.fields.data[other.fields.fields[0].offset] ^= 1; // the last bit of the first x
  saveCloud(file("other.pcd"), other, pcd_binary);
  expectRefused({file("other.pcd"), "--session", session_}, {"other coordinates"}, 1);
  setLabels(std::vector<std::uint32_t>(other.size(), 0), LabelType::U4, other);
  other.fields.data[other.fields.fields[0].offset] ^= 1;
  saveCloud(file("none.pcd"), other, pcd_binary);
  expectRefused({file("none.pcd"), "--session", session_}, {"'label' is 0"}, 1);
}

} // namespace
} // namespace pcl_cid::test
