#pragma once

#include "FieldSampler.h"
#include "ScalarField.h"

#include <memory>

/// A field of the C interface; its only material is the object.
struct palpate_field
{
  std::shared_ptr<const palpate::ScalarField> Field;
  palpate::FieldSampler Sampler;
};
