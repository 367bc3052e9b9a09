// The window touches everything that the command line can: models, surfaces, iso-values, scenes.
#include "StructureDialog.h"
#include "VolumeViscosity.h"
#include "WindowTest.h"

#include "ImageWriter.h"
#include "LabelImages.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "SceneFile.h"
#include "StructureTableModel.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include <QKeyEvent>
#include <QTabWidget>
#include <QTableView>

namespace palpate::added_structures_test
{
namespace
{
class AddedStructures : public test::WindowTest
{
protected:
  void SetUp() override
  {
    test::WindowTest::SetUp();
    const RadialModel sphere(0, {8.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
    WriteModel(this->Model, {sphere, {}});
    WriteSurface(this->Surface, DrawModel(sphere, 6));
  }
  // Two spheres, each in a file of its own.
  std::filesystem::path WriteMaskFolder() const
  {
    const std::filesystem::path folder = this->Phantom.Folder / "organs";
    std::filesystem::create_directory(folder);
    test::LabelGrid grid;
    grid.Size = {{48, 24, 24}};
    for (const auto& [name, middle] : {std::pair("liver", 12.0), std::pair("spleen", 36.0)})
    {
      WriteImage(folder / (std::string(name) + ".nii.gz"),
                 test::MakeLabelImage(grid, [x0 = middle](double x, double y, double z)
                                      { return std::hypot(x - x0, y - 12.0, z - 12.0) < 8.0; }));
    }
    return folder;
  }
  const SceneStructure& Last() const { return this->Study->State().Structures.back(); }
  std::shared_ptr<const TouchContact> Contact() const
  {
    return this->Study->Current().Pipeline().Newest<TouchContact>(SceneStep::Touch,
                                                                  this->Last().Id);
  }
  void WaitForContact(const std::string& kind)
  {
    WaitUntil([&] { return this->Contact() != nullptr; });
    EXPECT_NE(this->Contact()->Represented.find(kind), std::string::npos)
        << this->Contact()->Represented;
  }

  std::filesystem::path Model = this->Phantom.Folder / "ball.json";
  std::filesystem::path Surface = this->Phantom.Folder / "ball.stl";
};

TEST_F(AddedStructures, FolderOfMasksOpensAsStructuresNamedAfterFilesAndReopens)
{
  this->Chosen = QString::fromStdString(this->WriteMaskFolder().string());
  this->Action("Open folder")->trigger();
  WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
  EXPECT_EQ(this->Study->State().Structures[0].Name, "liver");
  EXPECT_EQ(this->Study->State().Structures[1].Name, "spleen");
  this->Settle();
  this->ExpectSameStudyAfterReopening();
  // Dropped on the window.
  this->Study->New();
  this->Study->OpenFiles({this->Phantom.Folder / "organs"});
  WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
}

TEST_F(AddedStructures, ModelIsTouchedAndDisplayed)
{
  this->Study->OpenFiles({this->Model});
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  this->WaitForContact("harmonics of degree 0");
  EXPECT_EQ(this->Window->Contents().Surfaces().count(this->Last().Id), 1U);
  this->Study->Undo();
  EXPECT_TRUE(this->Study->State().Structures.empty());
}

TEST_F(AddedStructures, SurfaceIsTouchedByItsFacets)
{
  this->OpenPhantom();
  this->Study->OpenFiles({this->Surface});
  WaitUntil([this] { return this->Study->State().Structures.size() == 4; });
  this->WaitForContact("facets");
  EXPECT_EQ(this->Window->Contents().Surfaces().count(this->Last().Id), 1U);
}

TEST_F(AddedStructures, MenuOpensFilesOfEveryKind)
{
  this->OpenPhantom();
  const auto session = this->Phantom.Folder / "case.palpate.json";
  this->Opened = QStringList{QString::fromStdString(this->Model.string()),
                             QString::fromStdString(this->Surface.string())};
  this->Action("Open...")->trigger();
  WaitUntil([this] { return this->Study->State().Structures.size() == 5; });
  this->Settle();
  ASSERT_TRUE(this->Study->Save(session)) << this->Messages();
  const StudyState saved = this->Study->State();
  this->Action("New study")->trigger();
  this->Opened = QStringList{QString::fromStdString(session.string())};
  this->Action("Open...")->trigger();
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  EXPECT_EQ(this->Study->State().Structures, saved.Structures);
  EXPECT_EQ(QSettings().value("recent").toStringList().first().toStdString(), session);
}

TEST_F(AddedStructures, SurfaceOpenedAsAVolumeIsAStructure)
{
  this->Opened = QStringList{QString::fromStdString(this->Surface.string())};
  this->Action("Open volume")->trigger();
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  this->WaitForContact("facets");
  EXPECT_TRUE(this->Study->State().VolumeFile.empty());
  EXPECT_EQ(this->Messages(), "");
}

TEST_F(AddedStructures, IsoValueOfTheVolumeIsTouchedByItsField)
{
  this->Study->OpenVolume(this->VolumeFile());
  this->Settle();
  this->Study->AddThreshold({350.0, {}, 0, {}});
  this->WaitForContact("sub-voxel field");
}

TEST_F(AddedStructures, RejectsIsoValueWithoutVolume)
{
  this->Study->AddThreshold({350.0, {}, 0, {}});
  EXPECT_TRUE(this->Study->State().Structures.empty());
  EXPECT_NE(this->Messages().find("no volume"), std::string::npos);
}

TEST_F(AddedStructures, SceneFileAddsStructuresAndTool)
{
  SceneSettings scene;
  scene.Structures.resize(2);
  scene.Structures[0].File = this->Model;
  scene.Structures[1].File = this->MaskFile();
  scene.Structures[1].Labels = {"1"};
  scene.Structures[1].SetNumber("viscosity_ns_per_mm", 0.01);
  scene.Tool.Radius = 1.5;
  const auto file = this->Phantom.Folder / "ball.scene.json";
  WriteWholeFile(file, SceneText(scene, this->Phantom.Folder.Path()));
  this->Study->OpenFiles({file});
  WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
  this->WaitForContact("sub-voxel field");
  EXPECT_EQ(this->Study->State().Tool.Radius, 1.5);
  EXPECT_EQ(this->Last().Number("viscosity_ns_per_mm"), 0.01);
  EXPECT_EQ(this->Study->State().SegmentationFile, this->MaskFile());
}

TEST_F(AddedStructures, DialogIsOneUndoStep)
{
  this->OpenPhantom();
  const int id = this->Study->State().Structures.front().Id;
  StructureDialog dialog(*this->Study, id);
  dialog.findChild<QDoubleSpinBox*>("damping")->setValue(0.002);
  dialog.findChild<QDoubleSpinBox*>("viscosity_ns_per_mm")->setValue(0.003);
  dialog.findChild<QComboBox*>("mode")->setCurrentIndex(1);
  dialog.accept();
  const SceneStructure& first = this->Study->State().Structures.front();
  EXPECT_EQ(first.Damping, 0.002);
  EXPECT_EQ(first.Number("viscosity_ns_per_mm"), 0.003);
  EXPECT_EQ(first.Mode, RadialContactMode::Radial);
  this->Study->Undo();
  EXPECT_EQ(this->Study->State().Structures.front().Damping, 0.0);
}

TEST_F(AddedStructures, DialogLetsAStructureYield)
{
  this->OpenPhantom();
  const int id = this->Study->State().Structures.front().Id;
  StructureDialog dialog(*this->Study, id);
  dialog.show();
  auto* modulus = dialog.findChild<QDoubleSpinBox*>("modulus_kpa");
  auto* representation = dialog.findChild<QComboBox*>("representation");
  EXPECT_FALSE(modulus->isVisible());
  representation->setCurrentText("elastic");
  EXPECT_TRUE(modulus->isVisible());
  modulus->setValue(30.0);
  dialog.findChild<QComboBox*>("free_side")->setCurrentText("posterior");
  dialog.findChild<QDoubleSpinBox*>("elements_across")->setValue(4.0);
  dialog.findChild<QDoubleSpinBox*>("inclusion_kpa")->setValue(60.0);
  dialog.accept();
  const SceneStructure& first = this->Study->State().Structures.front();
  EXPECT_EQ(first.Representation, TouchRepresentation::Elastic);
  EXPECT_EQ(first.Number("modulus_kpa"), 30.0);
  EXPECT_EQ(first.Number("free_side"), 3.0);
  EXPECT_EQ(first.Number("inclusion_kpa"), 60.0);
  EXPECT_EQ(first.Number("support_kpa_per_mm"), 0.0);
}

TEST_F(AddedStructures, TissueAndLesionAreInOneDialog)
{
  this->OpenPhantom();
  StructureDialog dialog(*this->Study, 1);
  dialog.findChild<QComboBox*>("representation")->setCurrentText("elastic");
  auto* modulus = dialog.findChild<QDoubleSpinBox*>("modulus_kpa");
  EXPECT_EQ(modulus->text(), "20 kPa (default)");
  auto* presets = dialog.findChild<QComboBox*>("tissue-preset");
  EXPECT_TRUE(presets->itemData(2, Qt::ToolTipRole).toString().contains("Ahn et al. 2010"));
  presets->setCurrentIndex(2);
  Q_EMIT presets->activated(2);
  EXPECT_EQ(modulus->value(), 17.0);
  dialog.findChild<QComboBox*>("lesion")->setCurrentIndex(2); // label 3
  dialog.accept();
  const auto& structures = this->Study->State().Structures;
  EXPECT_EQ(structures[0].Number("modulus_kpa"), 17.0);
  EXPECT_EQ(structures[2].Number("inclusion_kpa"), 24.1);
  StructureDialog again(*this->Study, 1);
  auto* lesion = again.findChild<QComboBox*>("lesion");
  EXPECT_EQ(lesion->currentIndex(), 2);
  lesion->setCurrentIndex(0);
  again.accept();
  EXPECT_EQ(this->Study->State().Structures[2].Number("inclusion_kpa"), 0.0);
  this->Study->Undo();
  EXPECT_EQ(this->Study->State().Structures[2].Number("inclusion_kpa"), 24.1) << "one undo step";
}

TEST_F(AddedStructures, DialogLetsAnOpenVolumeBeFeltAsStiffness)
{
  this->OpenPhantom();
  const std::filesystem::path open = this->Study->State().VolumeFile;
  ASSERT_FALSE(open.empty());
  StructureDialog dialog(*this->Study, this->Study->State().Structures.front().Id);
  dialog.show();
  auto* image = dialog.findChild<QComboBox*>("stiffness_image");
  EXPECT_EQ(image->currentText(), "") << "none is chosen by itself";
  auto* tabs = dialog.findChild<QTabWidget*>("details");
  tabs->setCurrentIndex(2);
  EXPECT_TRUE(image->isVisible());
  image->setFocus();
  QKeyEvent down(QEvent::KeyPress, Qt::Key_Down, Qt::NoModifier);
  QCoreApplication::sendEvent(image, &down);
  EXPECT_EQ(image->currentText().toStdString(), open.string());
  const auto type = [&dialog](const char* name, double value)
  { dialog.findChild<QDoubleSpinBox*>(name)->setValue(value); };
  type("stiffness_from_n_per_mm", 0.3);
  type("stiffness_from_value", -250.5);
  type("stiffness_to_n_per_mm", 1.2);
  type("stiffness_to_value", 700.0);
  dialog.accept();
  const SceneStructure first = this->Study->State().Structures.front();
  EXPECT_EQ(first.Image("stiffness_image"), open);
  EXPECT_EQ(first.Number("stiffness_from_n_per_mm"), 0.3);
  EXPECT_EQ(first.Number("stiffness_from_value"), -250.5);
  EXPECT_EQ(first.Number("stiffness_to_n_per_mm"), 1.2);
  EXPECT_EQ(first.Number("stiffness_to_value"), 700.0);
  EXPECT_TRUE(first.Image("texture_image").empty());
  const auto effects = [&]
  { return this->Study->Current().Pipeline().Newest<ImageEffects>(SceneStep::Effects, first.Id); };
  WaitUntil([&] { return effects() != nullptr; });
  ASSERT_NE(effects(), nullptr) << this->Messages();
  EXPECT_EQ(effects()->Made.count("stiffness image"), 1U);
}

// With the rows of a structure that yields, which are the most.
TEST_F(AddedStructures, DetailsFitASmallScreen)
{
  this->OpenPhantom();
  StructureDialog dialog(*this->Study, this->Study->State().Structures.front().Id);
  dialog.findChild<QComboBox*>("representation")->setCurrentText("elastic");
  dialog.show();
  for (int tab = 0; tab < 3; ++tab)
  {
    dialog.findChild<QTabWidget*>("details")->setCurrentIndex(tab);
    QCoreApplication::processEvents();
    const QSize wanted = dialog.minimumSizeHint().expandedTo(dialog.size());
    EXPECT_LE(wanted.height(), 700);
    EXPECT_LE(wanted.width(), 1024);
  }
  dialog.reject();
}

TEST_F(AddedStructures, OnlyLabelsAreInclusions)
{
  this->Study->OpenFiles({this->Model});
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  StructureDialog dialog(*this->Study, this->Last().Id);
  EXPECT_EQ(dialog.findChild<QDoubleSpinBox*>("inclusion_kpa"), nullptr);
  EXPECT_NE(dialog.findChild<QDoubleSpinBox*>("modulus_kpa"), nullptr);
}

TEST_F(AddedStructures, SofteningIsAStepOfThePipeline)
{
  this->OpenPhantom();
  auto* step = this->Window->findChild<QLabel*>("state-elasticity");
  EXPECT_TRUE(step->isHidden()) << "nothing yields";
  StudyState next = this->Study->State();
  next.Structures.front().Representation = TouchRepresentation::Elastic;
  next.Structures.front().Degree = 4;
  next.Structures.front().SetNumber("elements_across", 4.0);
  this->Study->Change("Let it yield", next);
  WaitUntil([step] { return !step->isHidden() && step->text() == "up to date"; });
  this->Settle();
  const auto contact = this->Study->Current().Pipeline().Newest<TouchContact>(SceneStep::Touch, 1);
  ASSERT_NE(contact, nullptr);
  EXPECT_EQ(contact->Represented, "elastic, 20 kPa, harmonics of degree 4");
  const auto* table = this->Window->findChild<QTableView*>("structures")->model();
  EXPECT_NE(table->index(0, StructureTableModel::RepresentationColumn)
                .data(Qt::ToolTipRole)
                .toString()
                .indexOf("elastic, 20 kPa"),
            -1);
  EXPECT_EQ(table->index(0, StructureTableModel::StiffnessColumn).data().toString(), "yields");
}

TEST_F(AddedStructures, InclusionOutsideIsAMessage)
{
  this->OpenPhantom();
  StudyState next = this->Study->State();
  next.Structures[0].Representation = TouchRepresentation::Elastic;
  next.Structures[0].Degree = 4;
  next.Structures[0].SetNumber("elements_across", 4.0);
  next.Structures[2].SetNumber("inclusion_kpa", 60.0); // three voxels elsewhere
  this->Study->Change("Let it yield", next);
  WaitUntil([this] { return this->Messages().find("lies outside of") != std::string::npos; });
  this->Settle();
  const std::string messages = this->Messages();
  EXPECT_NE(messages.find("mask.nii.gz, label 3 lies outside of label 1"), std::string::npos)
      << messages;
  next = this->Study->State();
  next.Structures[2].SetNumber("inclusion_kpa", 80.0);
  this->Study->Change("Another modulus", next);
  this->Settle();
  EXPECT_EQ(this->Messages(), messages) << "said once";
}

TEST_F(AddedStructures, MenuAddsStructuresOfASegmentation)
{
  this->OpenPhantom();
  const StudyState before = this->Study->State();
  const std::filesystem::path lesion = this->Phantom.Folder / "lesion.nii.gz";
  std::filesystem::copy(this->MaskFile(), lesion);
  this->Opened = QStringList(QString::fromStdString(lesion.string()));
  this->Action("Add structures of a segmentation")->trigger();
  WaitUntil([this] { return this->Study->State().Structures.size() == 6; });
  EXPECT_EQ(this->Last().File, lesion);
  this->Study->Undo();
  EXPECT_EQ(this->Study->State(), before);
  this->Study->Redo();
  EXPECT_EQ(this->Study->State().Structures.size(), 6U);
}

TEST_F(AddedStructures, SegmentationsOpenedTogetherAreAllThere)
{
  this->WriteMaskFolder();
  const std::filesystem::path folder = this->Phantom.Folder / "organs";
  const std::vector<std::filesystem::path> masks{folder / "liver.nii.gz", folder / "spleen.nii.gz"};
  this->Study->OpenFiles(masks);
  WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
  this->Settle();
  const StudyState both = this->Study->State();
  ASSERT_EQ(both.Structures.size(), 2U);
  EXPECT_EQ(both.Structures[0].File, masks[0]);
  EXPECT_EQ(both.Structures[1].File, masks[1]);
  // Asked for again, one replaces what is open.
  this->Study->OpenFiles({masks[1]});
  WaitUntil([&] { return this->Study->State().SegmentationFile == masks[1]; });
}

TEST_F(AddedStructures, DialogHasTheNumbersOfAddedEffects)
{
  SceneEffectKind kind;
  kind.Name = "adhesion";
  kind.Numbers = {{"adhesion_n", "Adhesion, N", 5.0, 2}};
  kind.Make = [](const SceneEffectSource&, const ProgressFunction&)
  { return std::make_shared<const VolumeViscosity>(0.0); };
  AddSceneEffectKind(kind);
  this->OpenPhantom();
  StructureDialog dialog(*this->Study, this->Study->State().Structures.front().Id);
  dialog.findChild<QDoubleSpinBox*>("adhesion_n")->setValue(0.25);
  dialog.accept();
  EXPECT_EQ(this->Study->State().Structures.front().Number("adhesion_n"), 0.25);
}
} // namespace
} // namespace palpate::added_structures_test
