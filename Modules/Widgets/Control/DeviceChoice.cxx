#include "DeviceChoice.h"

#include "OpenBuiltInDevice.h"

#include <QLineEdit>
#include <QMap>

#include <algorithm>

namespace palpate
{
namespace
{
// What a person calls a device; one with an argument has no other name.
const QMap<QString, QString>& DeviceNames()
{
  static const QMap<QString, QString> names{
      {"simulated", "Mouse (no device)"},    {"falcon", "Novint Falcon"},
      {"inverse3", "Haply Inverse3"},        {"openhaptics", "3D Systems Touch"},
      {"forcedimension", "Force Dimension"}, {"controller", "Game controller"},
      {"spacemouse", "SpaceMouse"}};
  return names;
}

QString LabelOf(const std::string& device)
{
  const QString word = QString::fromStdString(device);
  return DeviceNames().value(word, word);
}
} // namespace

DeviceChoice::DeviceChoice(QWidget* parent) : QComboBox(parent)
{
  DeviceRegistry registry;
  if (RegisterBuiltInDevices(registry).IsOk())
  {
    for (const DeviceRegistry::Kind& kind : registry.Kinds())
    {
      this->addItem(LabelOf(kind.Name));
    }
  }
  this->setEditable(true);
  connect(this->lineEdit(), &QLineEdit::textEdited, this, [this] { this->IsTyped = true; });
  connect(this, &QComboBox::currentTextChanged, this,
          [this]
          {
            if (!this->IsTyped)
            {
              this->Take();
            }
          });
  connect(this, qOverload<int>(&QComboBox::activated), this, &DeviceChoice::Take);
  connect(this->lineEdit(), &QLineEdit::editingFinished, this,
          [this]
          {
            if (this->IsTyped)
            {
              this->Take();
            }
          });
}

void DeviceChoice::Take()
{
  this->IsTyped = false;
  Q_EMIT Changed();
}

void DeviceChoice::Show(const std::vector<DeviceReport>& found)
{
  for (const DeviceReport& report : found)
  {
    const std::string kind = report.Name.substr(0, report.Name.find(':'));
    const auto ofKind = std::count_if(found.begin(), found.end(),
                                      [&](const DeviceReport& one)
                                      { return one.Name.substr(0, one.Name.find(':')) == kind; });
    const QString label = LabelOf(ofKind > 1 ? report.Name : kind);
    if (this->findText(label) < 0)
    {
      this->addItem(label);
    }
    this->setItemData(this->findText(label), QString::fromStdString(StateLine(report)),
                      Qt::ToolTipRole);
  }
}

void DeviceChoice::showPopup()
{
  Q_EMIT Opened();
  QComboBox::showPopup();
}

void DeviceChoice::Choose(const std::string& device)
{
  this->setCurrentText(LabelOf(device));
}

std::string DeviceChoice::Chosen() const
{
  return DeviceNames().key(this->currentText(), this->currentText()).toStdString();
}
} // namespace palpate
