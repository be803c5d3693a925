// Gives a decimater a module. Internal to lib/lod/decimation.
#pragma once

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>

#include "lib/lod/decimation/welded_surface.h"

namespace claque::lod
{

// OpenMesh makes the module first and then room for it in its list: where that fails, it loses the module.
template <class Module>
void add_module(OpenMesh::Decimater::DecimaterT<Mesh> &decimater, OpenMesh::Decimater::ModHandleT<Module> &handle)
{
    try {
        decimater.add(handle);
    } catch (...) {
        if (handle.is_valid()) delete &decimater.module(handle);
        throw;
    }
}

}  // namespace claque::lod
