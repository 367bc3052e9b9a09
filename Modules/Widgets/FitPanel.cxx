#include "FitPanel.h"

#include "ScreenString.h"

#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace palpate
{
FitPanel::FitPanel(StudyController& study, QWidget* parent) : QWidget(parent), Study(study)
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* important = new QFormLayout;
  important->setRowWrapPolicy(QFormLayout::WrapLongRows);
  column->addLayout(important);
  this->AddImportant(important);
  auto* unfold = new QToolButton(this);
  unfold->setObjectName("more-options");
  unfold->setText("More options");
  unfold->setCheckable(true);
  unfold->setAutoRaise(true);
  unfold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  unfold->setArrowType(Qt::RightArrow);
  column->addWidget(unfold);
  auto* folded = new QWidget(this);
  auto* others = new QFormLayout(folded);
  others->setRowWrapPolicy(QFormLayout::WrapLongRows);
  others->setContentsMargins(0, 0, 0, 0);
  column->addWidget(folded);
  folded->setVisible(false);
  this->AddOthers(others);
  connect(unfold, &QToolButton::toggled, this,
          [unfold, folded](bool isOpen)
          {
            folded->setVisible(isOpen);
            unfold->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
          });
  connect(&study, &StudyController::StateChanged, this, &FitPanel::Show);
  connect(&study, &StudyController::ProductsChanged, this, &FitPanel::ShowCoverage);
  this->Show();
  this->ShowCoverage();
}

void FitPanel::AddImportant(QFormLayout* form)
{
  this->AddNumber(
      form, "Degree of all", "Change the degree of all structures", {0.0, 64.0, 1.0, 0},
      [](const StudyState& state) { return state.Fit.Degree; },
      [](StudyState& state, double value)
      {
        const int degree = static_cast<int>(value);
        state.Fit.Degree = degree;
        for (SceneStructure& structure : state.Structures)
        {
          structure.Degree = degree;
        }
      });
  this->AddChoice(
      form, "Model", "Change the kind of model", {"radial", "surface", "automatic"},
      [](const StudyState& state) { return static_cast<int>(state.Fit.Model); },
      [](StudyState& state, int choice)
      { state.Fit.Model = static_cast<FitSettings::ModelKind>(choice); });
  this->AddChoice(
      form, "Surface", "Change the surface method", {"shape-interpolated", "plain"},
      [](const StudyState& state) { return static_cast<int>(state.Fit.Method); },
      [](StudyState& state, int choice)
      { state.Fit.Method = static_cast<FitSettings::SurfaceMethod>(choice); });
  this->AddNumber(
      form, "Smoothing, voxels", "Change the smoothing of surfaces",
      {0.0, FitLimits::Smoothing, 0.25, 2},
      [](const StudyState& state) { return state.Fit.Smoothing; },
      [](StudyState& state, double value) { state.Fit.Smoothing = value; });
  this->Coverage = new QLabel(this);
  this->Coverage->setObjectName("coverage");
  this->Coverage->setWordWrap(true);
  this->Coverage->setToolTip(
      "Reliability of the models: whether samples in all directions determine them");
  this->CoverageTitle = new QLabel("Coverage", this);
  form->addRow(this->CoverageTitle, this->Coverage);
}

void FitPanel::AddOthers(QFormLayout* form)
{
  this->AddChoice(
      form, "Left-handed files", "Change the handling of left-handed files",
      {"refuse", "reverse an axis"},
      [](const StudyState& state) { return static_cast<int>(state.LeftHanded); },
      [](StudyState& state, int choice)
      { state.LeftHanded = static_cast<LeftHandedAxes>(choice); });
  this->AddNumber(
      form, "Frequency", "Change the number of directions", {1.0, FitLimits::Frequency, 1.0, 0},
      [](const StudyState& state) { return state.Fit.Frequency; },
      [](StudyState& state, double value) { state.Fit.Frequency = static_cast<int>(value); });
  this->AddChoice(
      form, "Centre", "Change the choice of the centre", {"centroid", "most visible"},
      [](const StudyState& state) { return static_cast<int>(state.Fit.Center); },
      [](StudyState& state, int choice)
      { state.Fit.Center = static_cast<FitSettings::CenterChoice>(choice); });
  this->AddChoice(
      form, "Weight", "Change the weight of samples", {"area", "solid angle", "uniform"},
      [](const StudyState& state) { return static_cast<int>(state.Fit.Weight); },
      [](StudyState& state, int choice)
      { state.Fit.Weight = static_cast<FitSettings::SampleWeight>(choice); });
  this->AddChoice(
      form, "Robust", "Change the robust weights", {"off", "on"},
      [](const StudyState& state) { return state.Fit.IsRobust ? 1 : 0; },
      [](StudyState& state, int choice) { state.Fit.IsRobust = choice == 1; });
  this->AddChoice(
      form, "Repair", "Change the repair of surfaces", {"within limits", "always"},
      [](const StudyState& state) { return state.Fit.Repairs ? 1 : 0; },
      [](StudyState& state, int choice) { state.Fit.Repairs = choice == 1; });
  this->AddChoice(
      form, "Component", "Change the component", {"all", "largest", "second", "third"},
      [](const StudyState& state) { return std::min(state.Fit.Component, 3); },
      [](StudyState& state, int choice)
      {
        state.Fit.Component = choice;
        state.Fit.IsAlone = false;
      });
  this->AddNumber(
      form, "Maximum hidden, %", "Change the maximum hidden share", {0.0, 100.0, 1.0, 2},
      [](const StudyState& state) { return state.Fit.MaximumHiddenPercent; },
      [](StudyState& state, double value) { state.Fit.MaximumHiddenPercent = value; });
  this->AddNumber(
      form, "Minimum Dice", "Change the minimum Dice", {0.0, 1.0, 0.05, 2},
      [](const StudyState& state) { return state.Fit.MinimumDice; },
      [](StudyState& state, double value) { state.Fit.MinimumDice = value; });
  this->AddChoice(
      form, "Interpolation", "Change the interpolation of fields", {"linear", "cubic"},
      [](const StudyState& state) {
        return state.Structures.empty() ? 0
                                        : static_cast<int>(state.Structures.front().Interpolation);
      },
      [](StudyState& state, int choice)
      {
        for (SceneStructure& structure : state.Structures)
        {
          structure.Interpolation = static_cast<FieldInterpolation>(choice);
        }
      });
}

void FitPanel::AddNumber(QFormLayout* form, const QString& label, const QString& message,
                         const Range& range, std::function<double(const StudyState&)> get,
                         std::function<void(StudyState&, double)> set)
{
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(label);
  box->setDecimals(range.Decimals);
  box->setRange(range.Low, range.High);
  box->setSingleStep(range.Step);
  box->setKeyboardTracking(false);
  form->addRow(label, box);
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this, message, set = std::move(set)](double value)
          {
            StudyState next = this->Study.State();
            set(next, value);
            this->Study.Change(QString("%1 to %2").arg(message).arg(value), next, message);
          });
  connect(box, &QDoubleSpinBox::editingFinished, this, [this] { this->Study.EndGesture(); });
  this->Shows.emplace_back(
      [box, get = std::move(get)](const StudyState& state)
      {
        const QSignalBlocker quiet(box);
        box->setValue(get(state));
      });
}

void FitPanel::AddChoice(QFormLayout* form, const QString& label, const QString& message,
                         const QStringList& choices, std::function<int(const StudyState&)> get,
                         std::function<void(StudyState&, int)> set)
{
  auto* box = new QComboBox(this);
  box->setObjectName(label);
  box->addItems(choices);
  form->addRow(label, box);
  connect(box, qOverload<int>(&QComboBox::activated), this,
          [this, message, box, set = std::move(set)](int choice)
          {
            StudyState next = this->Study.State();
            set(next, choice);
            this->Study.Change(message + " to " + box->itemText(choice), next);
          });
  this->Shows.emplace_back([box, get = std::move(get)](const StudyState& state)
                           { box->setCurrentIndex(get(state)); });
}

void FitPanel::ShowCoverage()
{
  QStringList warnings;
  int models = 0;
  for (const SceneStructure& structure : this->Study.State().Structures)
  {
    const auto fit =
        this->Study.Current().Pipeline().Newest<FitResult>(SceneStep::Model, structure.Id);
    if (fit == nullptr || fit->State != FitResult::Outcome::Fitted)
    {
      continue;
    }
    ++models;
    if (fit->Coverage.Outcome != DirectionCoverage::Verdict::Good)
    {
      warnings += ScreenString(structure.Name + ": " + fit->Coverage.Message);
    }
  }
  this->Coverage->setText(warnings.isEmpty() ? QString("good") : warnings.join("\n"));
  this->Coverage->setVisible(models > 0);
  this->CoverageTitle->setVisible(models > 0);
}

void FitPanel::Show()
{
  for (const auto& show : this->Shows)
  {
    show(this->Study.State());
  }
}
} // namespace palpate
