#include "SceneProduct.h"

#include "CaseText.h"
#include "FitHints.h"

#include "vtkImageData.h"

namespace palpate
{
namespace
{
template <typename... Visitors>
struct Overloaded : Visitors...
{
  using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

std::size_t BytesOf(vtkDataObject* data)
{
  constexpr std::size_t Kibibyte = 1024;
  return data != nullptr ? Kibibyte * data->GetActualMemorySize() : 0;
}

// The refused or failed fit; null if there is none.
const FitResult* RefusedOf(const SceneProduct& product)
{
  return std::visit(Overloaded{[](const std::shared_ptr<const FitSurface>& surface)
                               { return surface->IsOver ? &surface->Found : nullptr; },
                               [](const std::shared_ptr<const FitSamples>& samples)
                               { return samples->IsOver ? &samples->Found : nullptr; },
                               [](const std::shared_ptr<const FitResult>& fit) {
                                 return fit->State != FitResult::Outcome::Fitted ? fit.get()
                                                                                 : nullptr;
                               },
                               [](const auto&) -> const FitResult* { return nullptr; }},
                    product);
}
} // namespace

std::string FailureOf(const SceneProduct& product)
{
  const FitResult* refused = RefusedOf(product);
  return refused != nullptr ? CaseMessage(refused->Input, refused->Structure, ReasonOf(product))
                            : ReasonOf(product);
}

std::string ReasonOf(const SceneProduct& product)
{
  const FitResult* refused = RefusedOf(product);
  const auto* failure = std::get_if<SceneFailure>(&product);
  const std::string message = failure != nullptr ? failure->Message : std::string();
  return refused != nullptr ? WithHint(refused->Message, refused->WindowHint) : message;
}

std::size_t BytesOf(const SceneProduct& product)
{
  return std::visit(
      Overloaded{
          [](const SceneFailure& failure) { return failure.Message.size(); },
          [](const std::shared_ptr<const Volume>& volume) { return BytesOf(volume->Image.Get()); },
          [](const std::shared_ptr<const Segmentation>& segmentation)
          {
            std::size_t bytes = 0;
            for (const auto& layer : segmentation->Layers)
            {
              bytes += BytesOf(layer.Get());
            }
            return bytes;
          },
          [](const std::shared_ptr<const FitSurface>& surface)
          { return BytesOf(surface->Found.Surface.Get()) + BytesOf(surface->Boundary.Get()); },
          [](const std::shared_ptr<const FitSamples>& samples)
          { return samples->Samples != nullptr ? samples->Samples->Bytes() : std::size_t{0}; },
          [](const std::shared_ptr<const FitResult>& fit)
          { return BytesOf(fit->ModelSurface.Get()); },
          [](const std::shared_ptr<const ScalarField>& field) { return field->Bytes(); },
          [](const std::shared_ptr<const TouchContact>& contact)
          {
            const bool isField = contact->Field != nullptr; // a product of its own
            return sizeof(*contact) + (isField ? 0 : contact->Model->Bytes());
          },
          [](const std::shared_ptr<const TouchCost>& cost) { return sizeof(*cost); },
          [](const std::shared_ptr<const ImageEffects>& effects) { return effects->Bytes(); },
          [](const std::shared_ptr<const SceneProtection>& protection)
          { return protection->Bytes(); },
          [](const std::shared_ptr<const SurfaceTool>& tool) { return tool->Bytes(); },
          [](const std::shared_ptr<const StructureDistance>& distance)
          { return distance->Bytes(); },
          [](const std::shared_ptr<const SceneInclusions>& inclusions)
          {
            std::size_t bytes = sizeof(*inclusions);
            for (const auto& [id, share] : inclusions->Shares)
            {
              bytes += sizeof(share) + share.Name.size();
            }
            return bytes;
          }},
      product);
}
} // namespace palpate
