#!/usr/bin/env bash
# Draws the pictures of docs/lighting.md again: tests/docs/lighting_pictures.sh [FOLDER], after make programs.
# Each picture is the same ball under one lamp, with some calls added or replaced; pictures of the lamp's factors have a floor.
set -euo pipefail
cd "$(dirname "$0")/../.."
twinlight=${TWINLIGHT_BUILD:-build}/twinlight
folder=${1:-docs/lighting}
mkdir -p "$folder"

# picture NAME [SHADING]: draws the scene of standard input.
picture() {
    "$twinlight" render - --with reference --size 400x300 --shading "${2:-phong}" -o "$folder/$1.png"
}

# The terms of the equation: 0 switches a term off.
emission='0, 0, 0' scene_ambient=0 diffuse=0 specular=0
# Calls after the others, which replace them.
extra=''
scene() {
    cat <<END
glClearColor(0.55, 0.6, 0.68, 1);
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glEnable(GL_DEPTH_TEST);
glMatrixMode(GL_PROJECTION);
gluPerspective(${field_of_view:-24}, 4.0 / 3.0, 1, 50);
glMatrixMode(GL_MODELVIEW);
gluLookAt(0, 2.2, 6,  0, ${look_at:-1}, 0,  0, 1, 0);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1.6, 2.6, 1.8, 1});
glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){$scene_ambient, $scene_ambient, $scene_ambient, 1});
glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){$diffuse, $diffuse, $diffuse, 1});
glLightfv(GL_LIGHT0, GL_SPECULAR, (GLfloat[]){$specular, $specular, $specular, 1});
glMaterialf(GL_FRONT, GL_SHININESS, 32);
glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.7, 0.7, 0.7, 1});
glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
glEnable(GL_LIGHTING);
glEnable(GL_LIGHT0);
$extra
glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){1, 0.5, 0.31, 1});
glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){$emission, 1});
glPushMatrix();
glTranslatef(0, 1, 0);
glutSolidSphere(1, ${slices:-96}, ${stacks:-48});
glPopMatrix();
${floor:-}
END
}
floor='glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0.75, 0.85, 1, 1});
glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0, 0, 0, 1});
glNormal3f(0, 1, 0);
glBegin(GL_QUADS);
glVertex3f(-6, 0, 4); glVertex3f(6, 0, 4); glVertex3f(6, 0, -6); glVertex3f(-6, 0, -6);
glEnd();'
with_floor=$floor floor=''

# ---- One term each, then the sum ----
(emission='0.1, 0.3, 0.15'; scene | picture emission)
(scene_ambient=0.35; scene | picture ambient)
(diffuse=0.8; scene | picture diffuse)
(specular=1; scene | picture specular)
(scene_ambient=0.35; diffuse=0.8; specular=1; scene | picture sum)

# ---- Factors of a light ----
all() { scene_ambient=0.2 diffuse=0.9 specular=1; }
on_floor() { all; floor=$with_floor field_of_view=34 look_at=0.75; }
(on_floor; scene | picture lamp)
(on_floor; extra='glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.1);'; scene | picture attenuation)
cone='glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){-1.3, -2.3, -1.6}); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 24);'
(on_floor; extra=$cone; scene | picture cone)
(on_floor; extra="$cone glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 16);"; scene | picture cone-exponent)

# ---- The highlight ----
for shininess in 4 32 128; do
    (all; extra="glMaterialf(GL_FRONT, GL_SHININESS, $shininess);"; scene | picture "shininess-$shininess")
done
(all; extra='#pragma twinlight specular(reflection)
'; scene | picture reflection)

# ---- Shading ----
for shading in flat gouraud phong; do
    (all; slices=16 stacks=10; scene | picture "shading-$shading" "$shading")
done
