// The names in shaders to keep.
#pragma once

#include "render/programmable/text/shader_pieces.h"

namespace twinlight::programmable {

// From the names of attributes and uniforms in the shader files to GL's, without the prefix gl_.
const Words& kept_names();

}  // namespace twinlight::programmable
