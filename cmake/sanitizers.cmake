# SPDX-License-Identifier: GPL-3.0-or-later
# Compiling under sanitizers takes two to three times as long, so that it can be had for some layers alone.

if(HULL_SANITIZE)
  add_compile_options(-fsanitize=${HULL_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # A null pointer and the end of an object are the address sanitizer's, too: a third less to compile.
  add_compile_options(-fno-sanitize=null,object-size,alignment)
  add_link_options(-fsanitize=${HULL_SANITIZE})
  # GCC and Clang have no macro in common that tells.
  add_compile_definitions(HULL_SANITIZED)
endif()

# hull_sanitize_layer(TARGET LAYER): a target of a layer that is not to be sanitized is not; its assertions stay.
function(hull_sanitize_layer target layer)
  if(HULL_SANITIZE AND HULL_SANITIZED_LAYERS AND NOT layer IN_LIST HULL_SANITIZED_LAYERS)
    target_compile_options(${target} PRIVATE -fno-sanitize=all)
  endif()
endfunction()
