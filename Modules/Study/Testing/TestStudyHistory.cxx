#include "StudyHistory.h"

#include "StudyCases.h"

#include <gtest/gtest.h>
#include <utility>

namespace palpate::study_history_test
{
namespace
{
StudyState WithDegree(const StudyState& state, int degree)
{
  StudyState changed = state;
  changed.Fit.Degree = degree;
  return changed;
}

// The oracle keeps every state in a list, with a current index.
TEST(StudyHistory, RandomUndoAndRedoEqualAPlainList)
{
  test::Random random(7);
  for (int trial = 0; trial < 20; ++trial)
  {
    StudyHistory history(test::RandomStudy(random));
    std::vector<StudyState> list{history.Current()};
    std::size_t place = 0;
    for (int step = 0; step < 100; ++step)
    {
      const int what = test::RandomWhole(random, 0, 2);
      if (what == 0)
      {
        StudyState next = test::RandomStudy(random);
        next.View = history.Current().View;
        ASSERT_TRUE(history.Change("step", next));
        list.resize(place + 1);
        list.push_back(next);
        ++place;
      }
      else
      {
        const bool can = what == 1 ? place > 0 : place + 1 < list.size();
        ASSERT_EQ(what == 1 ? history.Undo() : history.Redo(), can);
        place = can ? (what == 1 ? place - 1 : place + 1) : place;
      }
      ASSERT_EQ(history.Current(), list[place]);
      ASSERT_EQ(history.CanUndo(), place > 0);
      ASSERT_EQ(history.CanRedo(), place + 1 < list.size());
    }
  }
}

TEST(StudyHistory, StepHasOneNameForUndoAndRedo)
{
  StudyHistory history;
  history.Change("Change the degree to 14", WithDegree({}, 14));
  EXPECT_EQ(history.UndoText(), "Change the degree to 14");
  EXPECT_EQ(history.RedoText(), "");
  history.Undo();
  EXPECT_EQ(history.RedoText(), "Change the degree to 14");
  EXPECT_EQ(history.UndoText(), "");
}

TEST(StudyHistory, EqualStateIsNoStep)
{
  StudyHistory history;
  EXPECT_FALSE(history.Change("nothing", StudyState()));
  EXPECT_FALSE(history.CanUndo());
}

TEST(StudyHistory, DraggedSliderIsOneStep)
{
  StudyHistory history;
  for (const int degree : {13, 14, 15})
  {
    history.Change("Change the degree to " + std::to_string(degree), WithDegree({}, degree),
                   "degree");
  }
  EXPECT_EQ(history.UndoText(), "Change the degree to 15");
  history.EndGesture();
  history.Change("Change the degree to 16", WithDegree({}, 16), "degree");
  history.Undo();
  EXPECT_EQ(history.Current().Fit.Degree, 15);
  history.Undo();
  EXPECT_EQ(history.Current(), StudyState());
  EXPECT_FALSE(history.CanUndo());
}

TEST(StudyHistory, SliderDraggedBackLeavesNoStep)
{
  StudyHistory history;
  history.Change("to 14", WithDegree({}, 14), "degree");
  history.Change("to 12", StudyState(), "degree");
  EXPECT_FALSE(history.CanUndo());
  EXPECT_FALSE(history.IsChanged());
}

TEST(StudyHistory, UndoEndsAGesture)
{
  StudyHistory history;
  history.Change("to 13", WithDegree({}, 13));
  history.Change("to 14", WithDegree({}, 14), "degree");
  history.Undo();
  history.Change("to 15", WithDegree({}, 15), "degree");
  history.Undo();
  EXPECT_EQ(history.Current().Fit.Degree, 13);
}

TEST(StudyHistory, ViewIsNoStepAndIsKept)
{
  test::Random random(3);
  StudyHistory history;
  history.Change("to 14", WithDegree({}, 14));
  const StudyView view = test::RandomView(random);
  history.ChangeView(view);
  EXPECT_EQ(history.Current().View, view);
  history.Undo();
  EXPECT_EQ(history.Current().Fit.Degree, 12);
  EXPECT_EQ(history.Current().View, view);
  EXPECT_FALSE(history.IsChanged());
}

TEST(StudyHistory, KeepsAtMostTheAllowedSteps)
{
  StudyHistory history({}, 3);
  for (int degree = 20; degree < 30; ++degree)
  {
    history.Change("on", WithDegree({}, degree));
  }
  int undone = 0;
  while (history.Undo())
  {
    ++undone;
  }
  EXPECT_EQ(undone, 3);
  EXPECT_EQ(history.Current().Fit.Degree, 26);
}

TEST(StudyHistory, ReportsUnsavedChanges)
{
  StudyHistory history;
  history.Change("to 14", WithDegree({}, 14));
  EXPECT_TRUE(history.IsChanged());
  history.MarkSaved();
  EXPECT_FALSE(history.IsChanged());
  history.Undo();
  EXPECT_TRUE(history.IsChanged());
  history.Redo();
  EXPECT_FALSE(history.IsChanged());
}

TEST(StudyHistory, StateThatIsMarkedUnsavedIsChangedUntilSaved)
{
  StudyHistory history(WithDegree({}, 14));
  history.MarkUnsaved();
  EXPECT_TRUE(history.IsChanged());
  history.Amend(WithDegree({}, 15));
  EXPECT_TRUE(history.IsChanged());
  history.MarkSaved();
  EXPECT_FALSE(history.IsChanged());
}
} // namespace
} // namespace palpate::study_history_test
