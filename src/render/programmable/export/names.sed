# Renames the calls that gl_state.c has, in a program of C or C++: sed -E -i -f names.sed program.c
s/\b(gl|glu)(Begin|End|(En|Dis)able(ClientState)?|IsEnabled|(Push|Pop)Matrix|MatrixMode|LoadIdentity)\b/ff\2/g
s/\b(gl|glu)((LoadMatrix|MultMatrix|Translate|Rotate|Scale)[fd]|Frustum|Ortho|Ortho2D|Perspective|LookAt)\b/ff\2/g
s/\bgl((Light|LightModel|Material|Fog|TexEnv)[fi]v?|TexGen(i|fv)|ColorMaterial|ShadeModel|ClipPlane|AlphaFunc|PointSize)\b/ff\1/g
s/\bgl((Vertex|Normal|Color|TexCoord)([1-4](f|d|i|ub)v?|Pointer)|DrawArrays|DrawElements)\b/ff\1/g
