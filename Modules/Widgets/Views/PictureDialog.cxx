#include "PictureDialog.h"

#include "ViewPicture.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

namespace palpate
{
namespace
{
constexpr int SmallestSize = 64;
constexpr int Enlargement = 2; // of the views in the window, for print

QSpinBox* AddSize(QFormLayout* form, const QString& label, const char* name)
{
  auto* box = new QSpinBox;
  box->setObjectName(name);
  box->setRange(SmallestSize, PictureDialog::LargestSize);
  box->setSuffix(" pixels");
  box->setSingleStep(100);
  form->addRow(label, box);
  return box;
}
} // namespace

PictureDialog::PictureDialog(const ViewGrid& views, QWidget* window)
    : QDialog(window), Views(views), Window(window), Content(new QComboBox(this)),
      Transparent(new QCheckBox("Transparent background", this))
{
  this->setWindowTitle("Save picture");
  auto* form = new QFormLayout(this);
  this->Content->setObjectName("picture-content");
  this->Content->addItems(
      {"All views", "Axial view", "Coronal view", "Sagittal view", "3-D view", "The whole window"});
  form->addRow("&Picture of", this->Content);
  this->Across = AddSize(form, "&Width", "picture-width");
  this->Down = AddSize(form, "&Height", "picture-height");
  this->Transparent->setObjectName("picture-transparent");
  this->Transparent->setToolTip("Where no slice, surface or text is: for slides and posters");
  form->addRow(this->Transparent);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Save)->setText("&Save...");
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this->Content, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &PictureDialog::ProposeSize);
  this->ProposeSize();
}

ViewPane* PictureDialog::View() const
{
  const int view = this->Content->currentIndex() - 1;
  const auto& panes = this->Views.Panes();
  return view >= 0 && view < static_cast<int>(panes.size()) ? panes[static_cast<std::size_t>(view)]
                                                            : nullptr;
}

bool PictureDialog::IsOfWindow() const
{
  return this->Content->currentIndex() == this->Content->count() - 1;
}

void PictureDialog::ProposeSize()
{
  const bool isOfWindow = this->IsOfWindow();
  const ViewPane* view = this->View();
  const QSize shown = isOfWindow        ? this->Window->size()
                      : view != nullptr ? view->Canvas()->size()
                                        : this->Views.size();
  const QSize size = (isOfWindow ? 1 : Enlargement) * this->Window->devicePixelRatioF() * shown;
  this->Across->setValue(size.width());
  this->Down->setValue(size.height());
  for (QWidget* option : {static_cast<QWidget*>(this->Across), static_cast<QWidget*>(this->Down),
                          static_cast<QWidget*>(this->Transparent)})
  {
    option->setEnabled(!isOfWindow);
  }
}

QImage PictureDialog::Picture() const
{
  const QSize size(this->Across->value(), this->Down->value());
  const PictureGround ground =
      this->Transparent->isChecked() ? PictureGround::Transparent : PictureGround::AsShown;
  if (this->IsOfWindow())
  {
    return PictureOf(this->Views, *this->Window);
  }
  ViewPane* view = this->View();
  return view != nullptr ? PictureOf(*view, size, ground) : PictureOf(this->Views, size, ground);
}

QString PictureDialog::ProposedName() const
{
  const ViewPane* view = this->View();
  return (view != nullptr ? view->objectName() : QString("palpate")) + ".png";
}
} // namespace palpate
