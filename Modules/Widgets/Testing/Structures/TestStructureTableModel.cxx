#include "StructureTableModel.h"
#include "SurfaceFile.h"
#include "WindowTest.h"

#include <QTableView>

namespace palpate::structure_table_model_test
{
namespace
{
class StructureTableTest : public test::WindowTest
{
protected:
  QAbstractItemModel* Table() const
  {
    return this->Window->findChild<QTableView*>("structures")->model();
  }
  bool Write(int row, int column, const QVariant& value, int role = Qt::EditRole)
  {
    return this->Table()->setData(this->Table()->index(row, column), value, role);
  }
  const SceneStructure& First() const { return this->Study->State().Structures.front(); }
};

TEST_F(StructureTableTest, EditIsUndoStep)
{
  this->OpenPhantom();
  ASSERT_EQ(this->Table()->rowCount(), 3);
  EXPECT_TRUE(this->Write(0, StructureTableModel::StiffnessColumn, 1.25));
  EXPECT_EQ(this->First().Stiffness, 1.25);
  EXPECT_EQ(this->Study->Current().History().UndoText(), "Change label 1: stiffness 1.25 N/mm");
  EXPECT_TRUE(this->Write(0, StructureTableModel::NameColumn, "ball"));
  EXPECT_EQ(this->First().Name, "ball");
  EXPECT_TRUE(this->Write(0, StructureTableModel::RepresentationColumn, 2));
  EXPECT_EQ(this->First().Representation, TouchRepresentation::Facets);
  EXPECT_TRUE(this->Write(0, StructureTableModel::FrictionColumn, 0.5));
  EXPECT_EQ(this->First().Friction.Static, 0.5);
  EXPECT_EQ(this->First().Friction.Dynamic, 0.4);
  EXPECT_TRUE(this->Write(0, StructureTableModel::DegreeColumn, 1000));
  EXPECT_EQ(this->First().Degree, 64);
  EXPECT_NE(
      this->Messages().find("Degree 1000 is out of range, which is from 0 to 64: 64 is used."),
      std::string::npos)
      << this->Messages();
  for (int step = 0; step < 5; ++step)
  {
    this->Study->Undo();
  }
  EXPECT_EQ(this->First().Name, "");
  EXPECT_EQ(this->First().Stiffness, 0.5);
}

TEST_F(StructureTableTest, HiddenStructureIsInNoView)
{
  this->OpenPhantom();
  ASSERT_EQ(this->Window->Contents().Surfaces().count(1), 1U);
  EXPECT_TRUE(
      this->Write(0, StructureTableModel::VisibleColumn, Qt::Unchecked, Qt::CheckStateRole));
  EXPECT_FALSE(this->First().IsVisible);
  EXPECT_EQ(this->Window->Contents().Surfaces().count(1), 0U);
  this->Study->Undo();
  EXPECT_EQ(this->Window->Contents().Surfaces().count(1), 1U);
}

TEST_F(StructureTableTest, ShowsTickCostOfTouchableStructures)
{
  this->OpenPhantom();
  const auto cost = [this](int row)
  { return this->Table()->index(row, StructureTableModel::CostColumn).data().toString(); };
  WaitUntil([&] { return cost(0) != QString("\u2013"); });
  EXPECT_GE(cost(0).toDouble(), 0.0); // in hundredths of a microsecond
  EXPECT_EQ(cost(2), QString("\u2013")) << "of one voxel, which is refused";
}

TEST_F(StructureTableTest, DrawsStructureAsChosen)
{
  this->OpenPhantom();
  const ViewContents& shown = this->Window->Contents();
  const auto& pipeline = this->Study->Current().Pipeline();
  const auto show = [&](SceneAppearance appearance)
  {
    EXPECT_TRUE(
        this->Write(0, StructureTableModel::AppearanceColumn, static_cast<int>(appearance)));
    WaitUntil([&] { return !this->Study->IsBusy(); });
    this->Settle();
  };
  const auto model = pipeline.Newest<FitResult>(SceneStep::Model, 1);
  const auto surface = pipeline.Newest<FitSurface>(SceneStep::Surface, 1);
  const auto pointsShown = [&] { return shown.Surfaces().at(1)->GetSurface()->GetPoints(); };
  ASSERT_NE(model->ModelSurface->GetPoints(), surface->Found.Surface->GetPoints());
  show(SceneAppearance::Surface);
  EXPECT_EQ(pointsShown(), surface->Found.Surface->GetPoints());
  show(SceneAppearance::ErrorMap);
  EXPECT_EQ(pointsShown(), model->ModelSurface->GetPoints());
  EXPECT_STREQ(shown.Surfaces().at(1)->GetColorArray(), "DistanceToSurface");
  show(SceneAppearance::Model);
  EXPECT_EQ(pointsShown(), model->ModelSurface->GetPoints());
  EXPECT_STREQ(shown.Surfaces().at(1)->GetColorArray(), "");
  show(SceneAppearance::SubVoxel);
  WaitUntil([&] { return shown.Fields().count(1) == 1; });
  EXPECT_EQ(shown.Surfaces().count(1), 0U);
  EXPECT_EQ(this->Study->Current().History().UndoText(),
            "Change label 1: shown as sub-voxel volume");
  DrawAll(*this->Window->Views());
  SpacePane* space = this->Window->Views()->Space();
  const int drawn = space->RenderCount();
  EXPECT_TRUE(this->Write(0, StructureTableModel::ColorColumn, QColor(Qt::blue)));
  WaitUntil([&] { return space->RenderCount() > drawn; });
  this->Study->Undo();
  this->Study->Undo();
  EXPECT_EQ(shown.Fields().count(1), 0U);
  EXPECT_EQ(pointsShown(), model->ModelSurface->GetPoints());
}

TEST_F(StructureTableTest, ErrorMapsSwitchInOneUndoStep)
{
  this->OpenPhantom();
  this->Write(0, StructureTableModel::AppearanceColumn, static_cast<int>(SceneAppearance::Surface));
  this->Write(2, StructureTableModel::VisibleColumn, Qt::Unchecked, Qt::CheckStateRole);
  const StudyState before = this->Study->State();
  QAction* all = this->Action("All as error maps");
  EXPECT_FALSE(all->isChecked());
  all->trigger();
  EXPECT_TRUE(all->isChecked());
  const auto appearance = [this](std::size_t s)
  { return this->Study->State().Structures.at(s).Appearance; };
  EXPECT_EQ(appearance(0), SceneAppearance::ErrorMap);
  EXPECT_EQ(appearance(1), SceneAppearance::ErrorMap);
  EXPECT_EQ(appearance(2), SceneAppearance::Automatic) << "it is hidden";
  all->trigger();
  EXPECT_FALSE(all->isChecked());
  EXPECT_EQ(this->Study->State(), before);
  this->Study->Undo();
  EXPECT_TRUE(all->isChecked());
  this->Study->Undo();
  EXPECT_EQ(this->Study->State(), before);
}

TEST_F(StructureTableTest, ScaleOfErrorMapsDependsOnTheMaskUnlessChosen)
{
  this->OpenPhantom();
  const auto limit = [this] { return this->Window->Contents().Surfaces().at(1)->GetColorLimit(); };
  EXPECT_EQ(limit(), 0.0) << "no error map";
  this->Action("All as error maps")->trigger();
  this->Settle();
  EXPECT_EQ(limit(), 2.0) << "of voxels of 1 mm";
  StudyState coarser = this->Study->State();
  coarser.Structures.at(0).Degree = 2;
  this->Study->Change("Change the degree", coarser);
  this->Settle();
  EXPECT_EQ(limit(), 2.0);
  this->Action("\u00b15 mm")->trigger();
  EXPECT_EQ(limit(), 5.0);
  EXPECT_EQ(this->Study->State().View.ErrorScale, 5.0) << "part of the study";
  this->Action("Two voxels of the mask")->trigger();
  EXPECT_EQ(limit(), 2.0);
}

// Label 2 is a horseshoe.
TEST_F(StructureTableTest, ReportsReplacementOnceAndNotAsFailure)
{
  this->OpenPhantom();
  StudyState radial = this->Study->State();
  radial.Fit.Model = FitSettings::ModelKind::Radial;
  this->Study->Change("Fit radial models", radial);
  const std::string start =
      "label 2: touched by its sub-voxel field, because it is not star-shaped";
  WaitUntil([&] { return this->Messages().find(start) != std::string::npos; });
  EXPECT_EQ(this->Messages().find(start), this->Messages().rfind(start));
  EXPECT_EQ(this->Study->Current().Pipeline().StateOf(SceneStep::Samples, 2).Is,
            StudyStepState::Kind::Replaced);
  // If chosen explicitly, it is a failure of three steps, reported once.
  this->Write(1, StructureTableModel::RepresentationColumn,
              StructureTableModel::RepresentationNames().indexOf("harmonics"));
  const std::string failure = "label 2 is not star-shaped";
  WaitUntil([&] { return this->Messages().find(failure) != std::string::npos; });
  this->Settle();
  EXPECT_EQ(this->Messages().find(failure), this->Messages().rfind(failure));
}

TEST_F(StructureTableTest, QualityEqualsModelAndIsReadOnly)
{
  this->OpenPhantom();
  const QModelIndex quality = this->Table()->index(0, StructureTableModel::QualityColumn);
  const auto model = this->Study->Current().Pipeline().Newest<FitResult>(SceneStep::Model, 1);
  ASSERT_NE(model, nullptr);
  // Shown to a micrometre.
  EXPECT_NEAR(quality.data().toDouble(), model->ModelToMask.Mean, 0.00051);
  EXPECT_FALSE(this->Write(0, StructureTableModel::QualityColumn, 0.0));
  EXPECT_FALSE(this->Table()->flags(quality) & Qt::ItemIsEditable);
  // Label 3 is three voxels and has none.
  EXPECT_EQ(this->Table()->index(2, StructureTableModel::QualityColumn).data().toString(),
            QString(QChar(0x2013)));
}

TEST_F(StructureTableTest, QualityOfASurfaceFileIsTheDistanceFromIt)
{
  this->OpenPhantom();
  const auto model = this->Study->Current().Pipeline().Newest<FitResult>(SceneStep::Model, 1);
  ASSERT_NE(model, nullptr);
  const std::filesystem::path file = this->Phantom.Folder / "ball.stl";
  WriteSurface(file, model->Surface); // with the steps of its voxels
  this->Study->Current().AddStructure(file);
  StudyState state = this->Study->State();
  state.Structures.back().Representation = TouchRepresentation::Harmonics;
  const int id = state.Structures.back().Id;
  this->Study->Current().Change("Touch by harmonics", state);
  const auto fitted = [&]
  { return this->Study->Current().Pipeline().Newest<FitResult>(SceneStep::Model, id); };
  WaitUntil([&] { return fitted() != nullptr; });
  const int row = static_cast<int>(state.Structures.size()) - 1;
  const QModelIndex quality = this->Table()->index(row, StructureTableModel::QualityColumn);
  EXPECT_GT(quality.data().toDouble(), 0.0) << fitted()->Message;
  EXPECT_NEAR(quality.data().toDouble(), fitted()->ModelToSurface.Mean, 0.00051);
}
} // namespace
} // namespace palpate::structure_table_model_test
