#include "WindowTest.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>

#include <cmath>

namespace palpate::volume_panel_test
{
namespace
{
class VolumePanelTest : public test::WindowTest
{
protected:
  QDoubleSpinBox* Number(const char* name) const
  {
    return this->Window->findChild<QDoubleSpinBox*>(name);
  }
  void Choose(const char* preset)
  {
    auto* box = this->Window->findChild<QComboBox*>("window-preset");
    const int index = box->findText(preset);
    ASSERT_GE(index, 0);
    Q_EMIT box->activated(index);
  }
  vtkImageDisplay* Images() const { return this->Window->Contents().Images(); }
};

TEST_F(VolumePanelTest, NumbersAreThoseOfTheSlices)
{
  this->OpenPhantom();
  EXPECT_NEAR(this->Number("window")->value(), this->Images()->GetWindow(), 0.5);
  this->Images()->SetWindowLevel(300.0, 120.0);
  EXPECT_EQ(this->Number("window")->value(), 300.0);
  EXPECT_EQ(this->Number("level")->value(), 120.0);
  this->Number("window")->setValue(250.0);
  this->Number("level")->setValue(-30.0);
  EXPECT_EQ(this->Images()->GetWindow(), 250.0);
  EXPECT_EQ(this->Images()->GetLevel(), -30.0);
  EXPECT_EQ(this->Study->State().View.Window, 250.0) << "part of the study";
}

TEST_F(VolumePanelTest, PresetsSetWindowAndLevel)
{
  this->OpenPhantom();
  const double automatic = this->Images()->GetWindow();
  this->Choose("CT: bone");
  EXPECT_EQ(this->Images()->GetWindow(), 1800.0);
  EXPECT_EQ(this->Images()->GetLevel(), 400.0);
  this->Choose("Full range");
  const double* range = this->Images()->GetImage()->GetScalarRange();
  EXPECT_EQ(this->Images()->GetWindow(), range[1] - range[0]);
  this->Choose("Automatic");
  EXPECT_EQ(this->Images()->GetWindow(), automatic);
}

TEST_F(VolumePanelTest, FilesAreNamed)
{
  EXPECT_FALSE(this->Number("window")->isEnabled());
  this->OpenPhantom();
  EXPECT_TRUE(this->Number("window")->isEnabled());
  const QString volume = this->Window->findChild<QLabel*>("volume-name")->text();
  EXPECT_TRUE(volume.startsWith("volume.nii.gz  ")) << volume.toStdString();
  EXPECT_TRUE(volume.endsWith(" mm")) << volume.toStdString();
  EXPECT_TRUE(this->Window->findChild<QLabel*>("labels-name")->text().contains("3 structures"));
}
} // namespace
} // namespace palpate::volume_panel_test
