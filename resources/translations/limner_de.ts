<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scan, a project or a figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;folder of slices…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series or a stack of pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;labels…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a volume of label numbers that belongs to the scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open s&amp;ample head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the built-in head, to try things out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scans and projects that were open lately</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the figure as a picture with a size in millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave Limner Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat what was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the shown picture to the clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a lens under which what matters shows through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>St&amp;ipple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the figure with dots and lines of ink, and show their panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Scissors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut away what an outline drawn in the picture encloses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep the island here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on the part that stays; what is not connected with it goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on two places of the figure: how far they are from each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the patient&apos;s front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the patient&apos;s back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the patient&apos;s left side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the patient&apos;s right side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from above the head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from below the feet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Three-quarter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the front, turned and from a little above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3/4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill the sheet with what is visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a smaller part, larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show more, smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn freel&amp;y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn about any axis instead of keeping the horizon level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Variants…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sheet of the figure in other looks, or with a setting at several values; take one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay a look of your own over the figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep this look…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep styles, layers and ink of this figure under a name, for other scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import look…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the look of a file or of a project into your own looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete one of your own looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the gallery of styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a picture of a shaded ball to your own styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take from &amp;artwork…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a style from a scanned drawing or painting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paper &amp;colour…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay the figure on a plain paper of a colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay the figure over a picture, an artwork or a sheet of paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find any command by its name and do it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shortcuts…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See and change the keys of all commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Layouts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrangements of the panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Co&amp;lours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light or dark colours of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language of the window; the change shows at the next start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the &amp;picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide all panels, or bring them back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the whole screen, or the window again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Limner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CleanupWords</name>
    <message>
        <source>Erase %1 (label %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Erase label %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the largest island</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the island at a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove small islands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Erase a label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the largest island above %1, parted where thinner than %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the largest island above %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the island above %1 at %2, %3, %4 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove islands above %1 that are smaller than %2 mm³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scissors: %1 points, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outside</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>0: not seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A CT whose values were cut to 8 bits: soft tissue, blood and bone by brightness.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A casting or assembly: a glassy body around its dense parts, steel and brass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A colour or a picture behind the figure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A few slices of a CT as an anatomical section: fat, muscle, organs, blood and bone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A head CT with glassy skin over an ivory skull.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A micro-CT of a tooth: dentine and enamel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture laid on the object, apart from the lighting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A point of the island that stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A point of the scan that the lens follows as the view turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A ray ends where less than this share of light is left; 0: never.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A seam that parts what is in front from what is behind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A single slice head on, in greys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A soft shadow on what lies close behind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accuracy against time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aerial perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the first axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the second axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the view, or along an axis of the patient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ambient occlusion, contact shadow and halos.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An MR head cut level above the eyes: skin outside, the brain&apos;s section inside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another number spreads the dots otherwise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another scan on the same grid, for two-dimensional transfer functions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any scan with a boundary: the surface in warm wax, dense matter in ivory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arteries of an angiography, or contrast-filled vessels of a CT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As a share of the figure&apos;s height.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As they are, or drawn from a copy in the 256 levels that fit the scan best: half as large, at an error that is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between voxels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue shade turns smoothly into warm light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bound of the Laplacian of Gaussian for a line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boundaries and silhouettes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boundaries matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brain (MR)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bright data matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brown shade and creamy light, as in a wash drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cartoon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check sum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clean airbrushed tissue in the colours of today&apos;s atlases, on white.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clean-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clip box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clipping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour and opacity of the paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour at the key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour by position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of each label number, as #rrggbb.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the outline.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the seam: dark, or the paper&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour ramp from shade to light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coloured chalk on a dark board, as drawn in the lecture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact shadow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contour thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contrast-filled heart and great vessels with the bones around them, from a CT angiography.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cool to warm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Credit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crossing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts are drawn flat, in a style of their own or the layer&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DICOM series where the folder holds several.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Darkening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data value of the node.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deep blue shade under pale moonlight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dense matter matters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth cues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth fade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth that is sharp, from the front (0) to the back (1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of the largest dots on paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction to the light: right, up, towards the viewer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of samples on a ray, in smallest voxel spacings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance over which the curvature is measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dot size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots behind matter are removed or shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots gather on boundaries and where surfaces turn away, with lines along the silhouettes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots lie evenly on paper, or on the volume, where they stay when it turns (a moving picture&apos;s always do).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots lie in the shade; what faces the light stays paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots lie over the drawn layers or under their opacity, or alone: the layers are not drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots of ink.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots on every surface alike, the more the sharper it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots take the colour of the style under them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots that a full boundary adds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots that the silhouette adds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots where the surface faces the viewer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots without any boundary.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawn styles, Phong&apos;s light, or flat colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each label of a label volume in its own colour, with thin contours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Early end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge of the lens: hard, soft or a screen of dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge of the tile on the object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Embedded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even, or thinner where the form is flat (curvature) or far (depth).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent of the highlight&apos;s part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent of the lit flats&apos; part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent of the part without boundary.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extinction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of the importance away from the lens.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of the importance in the middle of the lens.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor on the number of dots; 0: no dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factors of red, green, blue and opacity; above 1 brightens.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fewer dots in the light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fewer dots inside matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fewer dots where the volume looks smaller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File or folder of the scan, relative to the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixed to the viewer&apos;s head, or to the object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Focus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four flat tones with three hard steps between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From full to none, by the cosine between normal and view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From no outline to all of one, by 1 less the cosine of normal and view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the object towards the light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From where the figure is seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full vertical angle of a perspective view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gradient threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Graphite study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gray&apos;s engraving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest importance: at 8, matter needs an opacity of 0.03 % to show through all that is in front; at 20 the faintest haze does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Haeckel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half spaces that are cut away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the angle under which the light is seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Halos</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hatching</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heart and aorta</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the printed figure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of what the picture shows at the target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden dots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highlights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highlights as of a wet or polished surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hollows and crevices are darker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How dark hollows get; 0: not at all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How dark outlines are drawn; 0: not at all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How dark the shadow is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far around a place its statistics are taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far around a place matter takes its light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far behind the seam reaches its full width.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far dots lie around the surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the interior of matter is cleared of dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far things cast their shadow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast dots thin out with distance from the viewer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast the layer blurs away from the focus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much an outline&apos;s boundary must stand out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much importance overrules what lies in front; 0: not at all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of what lies behind the halo hides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the object matters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How sharp a ridge must be for a line; 0: no ridges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How sharp a valley must be for a line; 0: no valleys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How sharply boundaries count.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How sharply lit parts are cleared of dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How sharply the silhouette counts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How surface directions are measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How surfaces are found: by regression over 27 voxels (Neumann), or by central differences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id of a style in the figure&apos;s list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importance of labelled objects.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importance of the paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In figure coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Industrial part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ink from style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ink plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inner lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Island at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Islands with less volume than this are removed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labelled parts matter by their weight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labelled regions, each in its own colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labels, full path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest cosine between normal and view on a line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest error asked for; the step is chosen to meet it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lasso&apos;s format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lasso&apos;s view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers without it are not drawn while any layer has it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout of headerless data: 256x256x230:uint16:le:0.5,0.5,0.7.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the strokes on paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length that the scale bar stands for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lettering, scale bar and orientation marks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Licence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light on what faces the viewer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light that reaches every place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line opacity by gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines along ridges and valleys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines along silhouettes, ridges and valleys; no dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines along the silhouettes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines behind matter are left out, dashed or thin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines where the surface turns away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lit from the upper left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low and high corner; what is outside is cut away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matter above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matter thinner than this never comes forward, so that noise stays hidden.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matter thinner than twice this does not connect, so that a headrest that touches the skin goes; 0: plain connection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured from second derivatives, or from two normals on the ray.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modern textbook</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More dots on boundaries.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More dots on near parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More dots on silhouettes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the opacity of the whole layer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name for people.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of each label number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the layer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near parts are dark and far ones fade into the paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near parts darker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near parts get more dots; negative: far parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near things are warm and full, far ones cool and light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near things are warm, far ones cool; nothing fades.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neighbourhood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Night blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No paper behind the figure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the label to erase.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the object&apos;s label.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers in a row of a mask.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the axis &quot;direction&quot;, in the patient&apos;s coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the seam around what is in front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One hard edge between shade and light, as in a poster.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only these label numbers show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity by gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity inside the shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity of the outline.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer surfaces clear in the middle, so that inner ones show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline in a colour of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline in figure coordinates, at least three points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline of the lens.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outlines matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outlines only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel rays, or rays from an eye.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen and ink (hatching)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen, brush and grey washes in black ink.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pencil from hard to soft on smooth paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phong&apos;s light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture inside the project, or a path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture inside the project, or bundled:ID.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels per inch of paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place in figure coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places where importance acts; none: everywhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Placing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain colour instead of a style.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain colour of the cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain stipple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points (gradient 0 to 1, factor of the opacity).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points (value, opacity) by rising value; two at one value are a step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points to the side that is cut away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions of the shape&apos;s corners on the first axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions of the shape&apos;s corners on the second axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rays per pixel: 1, 4 or 16.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the scan&apos;s values and picks the preset that suits it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red-chalk study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rising positions of the grid&apos;s columns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rising positions of the grid&apos;s rows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SHA-256 of the stored numbers; tells when the scan has changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sanguine and black chalk, heightened with white on cream paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saturated lithographs with cool shadows, after the plates of Haeckel&apos;s time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan, full path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See-through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Segmentation of the scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sepia wash</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shade and rim matter more than lit flats.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape in the plane of the two axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shapes in the plane of the two axes (2d).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the radius over which a hard edge fades.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shares of ambient and diffuse light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silhouette curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size and resolution of the printed figure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the scan&apos;s file or files; 0: not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the screen&apos;s dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skeleton of a body CT under a hint of skin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin over bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skull</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest gradient on a line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest gradient that gets dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest island</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Softness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specimen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps that remove what is not wanted; the scan itself stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stipples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength of the highlight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength of the tone&apos;s colour; 0 leaves only its brightness.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes along the form&apos;s curvature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes follow the form and cross in the shade; no dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style ids, a row per position of the second axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style of the cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Styles by one measure of the data, or by two.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Styles or colours along the axis, by rising value (1d), or a grid of styles (2d).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terms of the artwork.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The back of a surface is drawn like its front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bare bones of a head CT, ivory with enamel teeth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The higher, the smaller the highlight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layer blurs away from the focus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layer is safe from changes in the studio.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lower end of the scan fades away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measure that picks style and opacity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The painted mask, row by row from the low end of the second axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pen keeps its width on flat and bent surfaces alike.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The point in the middle of the picture, in patient coordinates (LPS).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The point in the patient that the leader points to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The point that distances are measured from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same everywhere, or clearing flat regions first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same for silhouette and highlights.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan lies inside the project file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan that is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The styles that the figure uses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface of a head or body, CT or MR, as a portrait.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tone is the share of inked paper, or the share of the most dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two measures that pick style and opacity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view in which the outline was drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The way the viewer looks; any length but zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tints along the axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tints along the view or an axis: aerial perspective.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Title of the figure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone above which strokes cross; 1: never.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torso bones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparent washes on white paper, the lights left open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tried when the project moved without its labels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tried when the project moved without its scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns an ellipse or a box counter-clockwise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two tones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-sided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unocclusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Valleys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical fade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume of label numbers, relative to the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warm light and cool shade over the colours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warm to cool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watercolour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of the layer in importance composition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What counts as an outline.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What counts as lit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What differs from its surroundings matters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is above this value counts as matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is cut away from this layer alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is cut away to see inside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is drawn, one after the other at every sample.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is far fades away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is removed before drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is up in the picture; not along the direction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What makes a sample important.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What matters shows through what lies in front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What nothing hides matters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What stands on the figure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the dots take for matter: the data as they are, or what the layers show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What themes exchange the style by: bone, skin, vessel ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What transfer functions call the style.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where along the axis, from 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where normal · position is larger, matter is cut away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where on the ramp, from shade (0) to light (1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the axis &quot;distance&quot; starts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the light comes from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the shadow&apos;s light comes from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the tone&apos;s light comes from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the layer is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which side of the outline is cut away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which styles and opacity the data get.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who made the artwork.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the lines on paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the pen on paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the printed figure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the soft border as a share of the shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the strokes on paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width over height of the figure in which the outline was drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width over height, of an ellipse or a box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Windowed CT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without a point: the label that distances are measured from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wood engraving on old paper with arteries and veins overprinted in red and blue.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExtractionWords</name>
    <message>
        <source>How much of the ball was seen in the artwork; the rest is filled in from around it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a form that shows more sides, erase less, or leave fewer letters out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the form, shaded again with this style, is from the artwork (root mean square of the colours, 0 to 1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at “Difference”: where it is not grey, mark normals and creases, ignore letters, or choose a form of one material.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The widest gap between directions that were seen; it is filled smoothly, without guessing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take in the part of the form that faces that way, or make the style symmetric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest hole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the style would change if the outline were snapped to the picture&apos;s edge.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press “Snap to edge”, or drag the outline&apos;s handles onto the edge.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Placement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the style would change if the form were deeper by a quarter: no picture tells its depth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set “Depth” to what you know of the form, or mark some normals inside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>poor</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudioLanguage</name>
    <message>
        <source>As the desktop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::Actions</name>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ArtworkCanvas</name>
    <message>
        <source>Artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scanned artwork. The wheel zooms, the middle button or Space moves it; arrow keys move what is chosen, Delete removes it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ArtworkToolBar</name>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a style from a round thing: a ball, an eye, a fruit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the circle, for a ball seen at an angle or egg-shaped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Region</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a style from any shaded form: drag around it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint more of the form, or erase some of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tell how the form faces at a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crease</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a ridge or a valley of the form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tell where the form goes on behind something or is cut off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint over letters and lines that are not the form&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a style of two to five colours picked from the artwork</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ArtworkToolOptions</name>
    <message>
        <source>From the &amp;centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw from the ball&apos;s centre; off: from edge to edge (Alt does the other)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lets the outline follow the picture&apos;s edge near it (S)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find the edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fits a rough outline to the form it means; off: takes it as drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the brush on the screen ([ and ])</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks printed letters and leader lines; paint to add, Alt to erase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes all of this painting away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes the chosen mark (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the light falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between light and shadow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned away from the light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the edge: reflected light, an ink line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The small bright spot of something shiny</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the chosen colour away (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::BrushTool</name>
    <message>
        <source>Erase form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look here again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ignore here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint the form; Alt erases; [ and ] change the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint over letters and lines that are not the form&apos;s; Alt erases; [ and ] change the brush</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::CleanupForm</name>
    <message>
        <source>&amp;Add step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>La&amp;ter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is taken away. Add a step to remove a table, a headrest, crumbs or a label; the scan itself stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Look from there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clean-up steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen step runs before the one above it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen step runs after the one below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the chosen step; what it took away comes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a step after the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is inside the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side that is cut away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the figure to the view in which the outline was drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label to erase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;ut away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>La&amp;bel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the lasso&apos;s view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change label to erase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete clean-up step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reorder clean-up steps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ClipForm</name>
    <message>
        <source>Plane %1: %2 side cut away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut along the view here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of cuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right to left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front to back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom to top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the box begins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the box ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add clip box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove clip box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move side of clip box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a plane through the middle of the view that faces the viewer: what is nearer goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut away the other side of the chosen plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut along the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip clip plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove clip plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move clip plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change colour of cuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change cut faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the data are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat, as the layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat, in a colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat, in “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ClipOverlay</name>
    <message>
        <source>Crop box: the patient&apos;s right side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crop box: the patient&apos;s left side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crop box: front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crop box: back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crop box: bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crop box: top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clip plane %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Drag it, or use the arrow keys: 1 mm, with Shift 0.1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move cut</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::CommandPalette</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands that match</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::CreaseTool</name>
    <message>
        <source>Tilt crease</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move crease</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change crease</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw crease</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove crease</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>valley %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ridge %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline a form first (Region), then draw its creases here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click for the next corner; Enter, a double click or the right button ends; Backspace takes one back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the round handle: up for a ridge, down for a valley; drag corners to move them; Delete removes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click along a ridge or a valley of the form</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::CurveEditor</name>
    <message>
        <source>Curve over the %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a point to move it, double click for a new one; the right button or Delete removes a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::EllipseTool</name>
    <message>
        <source>Move outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resize outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the round thing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to take this round thing, or drag to draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the handles; arrow keys move, Delete removes; drag elsewhere to draw anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from a ball&apos;s centre to its edge (Alt: from edge to edge)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from edge to edge across a ball (Alt: from its centre)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from a ball&apos;s centre (Alt: from corner to corner, Shift: a circle)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the box around a ball (Alt: from its centre, Shift: a circle)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ExportDialog</name>
    <message>
        <source>PNG – screen, slides, journals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIFF – print</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JPEG – small, with losses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WebP – web pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenEXR – compositing, 32-bit float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG – ink as circles and paths, to go on drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF – ink as circles and paths, print</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep proportions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width and height change together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> dpi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels per inch of paper: 300 for halftones, 600 to 1200 for line art, 96 for screens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bits of each colour: 16 where the picture will be graded further</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 ray per pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rays per pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More rays make edges smoother and take as many times longer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing behind the figure instead of its background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JPEG cannot be transparent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Ink as vectors&lt;/b&gt;; shaded layers as a picture of&lt;br&gt;%1 × %2 pixels, at most %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 × %2 pixels&lt;/b&gt;&lt;br&gt;at most %3 before compression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 to draw</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ExtractionDialog</name>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letters and leader lines are marked; paint to add, Alt erases.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no letters on this artwork.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style from artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style from artwork – %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.psd *.webp *.exr *.bmp);;Everything (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no picture on the clipboard; copy one, or open a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a dashed outline to take it, or draw around a form.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing stands out within the outline: it is taken as drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush and Shift or Alt with the lasso mend the form; normals and creases tell its shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no edge near the outline to follow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline follows the edge now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a dashed outline or draw around a form: the style appears here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick light and shadow: the style appears here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open an artwork to take styles from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No style comes of this form; the line above the artwork says why.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scan to use styles on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen layer is locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figure with the style is shown here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is in your styles and on the figure. Draw the next form, or close.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is in your styles. Draw the next form, or close.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style not added</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The style on the ball has not been added. Close without it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dropped picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat what was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open artwork…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scanned artwork; it can be dropped here, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the picture on the clipboard as the artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show one pixel of the artwork as one of the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Take styles from an artwork&lt;/b&gt;&lt;br&gt;Open a scanned plate or a painting, drop the file here, or paste a picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the figure</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ExtractionForm</name>
    <message>
        <source>Show what is filled in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tints the parts of the ball that were not seen in the artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How deep the form is: 1 as deep as it is wide, less for a relief</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evens out grain and hatching, edges of light and shadow stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the light counter-clockwise about the line of sight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity by &amp;angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the style clearer where it faces the viewer, or at its rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>facing → rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;ymmetric about the light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the mean of the ball and its mirror image: what is not lighting goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove paper &amp;cast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As if painted on white paper instead of this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Leave letters out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Printed letters and leader lines over the form are not looked at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Separate te&amp;xture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps grain, hatching and patterns as a tile beside the lighting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texture tile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the lighting does not explain, as a tile without seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side of the style&apos;s picture; 512 is plenty for print</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The style as a ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re-shaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The form, shaded again with the style: it should look like the artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grey: as in the artwork; lighter or darker: the artwork is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;urn light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity by angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage, residual and holes are told here once a style is extracted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made of picked colours: there is nothing to measure it by.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ExtractionView</name>
    <message>
        <source>Extracted style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys, to turn the light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picked colours have no region to compare with.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ExtractionWork</name>
    <message>
        <source>Opening artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for round things</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fitting the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extracting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adding the style</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::FigurePreview</name>
    <message>
        <source>The figure in this style</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::GalleryList</name>
    <message>
        <source>Mine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bundled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to use it, or drag it onto the transfer function or the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter puts the style onto the layer, Control D makes it a favourite, F2 renames it, Delete removes one of your own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No styles of your own yet. Take one from an artwork, or import a picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, a favourite, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show these styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fold these styles away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, folded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, heading</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ImportanceForm</name>
    <message>
        <source>Let what matters &amp;show through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Important matter is seen through what lies in front of it, without cutting anything away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What matters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it matters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what matters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show nothing through</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::IslandOverlay</name>
    <message>
        <source>Keep the island here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is too little to see here to keep · click on the part that stays · Esc: leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on the part that stays; what is not connected with it goes · Esc: leave</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::LabelList</name>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show every label that is listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide every label that is listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of a label&apos;s name, or its number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labels of the layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The check mark shows or hides a label in the selected layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counting labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
Label %2, %3 voxels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show label “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide label “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide labels</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::LayerForm</name>
    <message>
        <source>Even &amp;width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the opacity of the whole layer, in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer opacity in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Illustrative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Illustrative: clear where the surface faces the viewer, opaque where it turns away, as illustrators draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change transparency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How light is drawn: by the styles, by a head light, or not at all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws lines where the surface turns away, in the colours of the styles&apos; rims</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contour thickness in millimetres on paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the pen on paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line follows the curvature: it keeps its width on flat and bent surfaces alike, not only on round ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change contour thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transpa&amp;rency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sh&amp;ading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change layer opacity</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::LayerList</name>
    <message>
        <source>Layer %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a layer behind the selected one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the selected layer earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the selected layer later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the selected layer another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it to delete it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solo layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End solo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::LayerPanel</name>
    <message>
        <source>Depth cues, over all layers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::LayerRows</name>
    <message>
        <source>S</source>
        <comment>solo</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solo: draw only this layer, and others that are solo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock the layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock: keep the layer from being changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The check mark shows or hides the layer; a double click renames it; drag to reorder</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::LensForm</name>
    <message>
        <source>Add &amp;lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Follow the anatomy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importance acts under the lenses only; without any it acts everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a lens in the middle of the figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lens stays on the same place of the body as the view turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let go of lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circular, with an edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian, fading out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screen door, of dots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape of the lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change kind of lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change shape of lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;hape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1 of lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lens %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove lens</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::LensOverlay</name>
    <message>
        <source>Lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen lens. Arrow keys move it, plus and minus resize it, Delete removes it, Escape leaves it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resize lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove lens</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::LightBall</name>
    <message>
        <source>Direction of the light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag over the ball to move the light; outside its rim the light comes from behind</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::LightForm</name>
    <message>
        <source>With the viewer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixed to the scan</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::MainWindow</name>
    <message>
        <source>Styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back&amp;ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main tool bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay a ready-made look over the figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchange all styles and the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the picture is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limner Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2 × %3 · %4 ms · %5 M samples · %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>final</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backend, pixels, time and samples of the shown picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source> · %n notice(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Clean-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading styles, presets and themes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the sample head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scans and projects (*.limner *.json *.dcm *.nii *.nii.gz *.hdr *.img *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.tif *.tiff *.png *.inv3 *.inv3.gz);;Everything (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open folder of slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label volumes (*.nii *.nii.gz *.hdr *.img *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.tif *.tiff);;Everything (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preset “Labelled” draws each label in a colour of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limner project (*.limner);;Bare figure (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 picture (*.%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change output size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied %1 × %2 pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to “%1” first?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Limner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Limner %1&lt;/b&gt;&lt;br&gt;From CT and MR scans to print-ready illustrations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0. A figure shows what is in the scan; it is not a medical device and not for diagnosis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Small pictures</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::MeasureOverlay</name>
    <message>
        <source>Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is too little to see here to measure · click on the figure · Esc: leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on the first place · Esc: leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on the second place · Backspace: take it back · Esc: leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on a third place for the angle · Backspace: take it back · Esc: leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to measure anew · Esc: leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::NormalTool</name>
    <message>
        <source>Mark a normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline a form first (Region), then tell its normals here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the needle to turn and tilt it; Ctrl+drag or arrow keys move, Delete removes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press where you know how the form faces, and drag the needle the way it leans</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::NoticeBar</name>
    <message>
        <source>Notices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide this notice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::OpenOutlineTool</name>
    <message>
        <source>Open the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline a form first (Region), then tell where its outline is no edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag along the outline where the form goes on, hidden or cut off; click one and Delete to remove it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::OutlineTool</name>
    <message>
        <source>Take away from the form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag around a new form; Shift adds to this one, Alt takes away from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag roughly around a shaded form: its edge will be found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag around a shaded form, along its edge</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ParameterRow</name>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, number</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::PartForm</name>
    <message>
        <source>Change range of silhouette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full up to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing: even lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curvature: thin where flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth: thin where far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move light</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::PickerTool</name>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the colour of “%1”; light and shadow are enough, drag on the ball to turn the light</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::PositionForm</name>
    <message>
        <source>Colour by position “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View: near to far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right to left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front to back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom to top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view&apos;s direction here, kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change axis</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::PresetMenu</name>
    <message>
        <source>&amp;Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ProgressStrip</name>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop this; nothing is left behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::RampCanvas</name>
    <message>
        <source>Colour ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a key to move it, double click it for another colour, double click the ramp for a new key; the right button or Delete removes a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::RampEditor</name>
    <message>
        <source>Colour of the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a key half way to the next one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the ramp jump at the selected key instead of running towards it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected key (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the selected key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the selected key lies on the ramp, from 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity at the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of the layer&apos;s opacity at the selected key, in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness at the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strongest factor of the layer&apos;s colours at the selected key; above 100 % brightens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset  </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a ready-made ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change colour of key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change opacity of key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change brightness of key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make step</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ScissorsOverlay</name>
    <message>
        <source>Scissors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I: cut what is outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I: cut what is inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scissors: draw around what goes, or click corners · %1 · Esc: leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter or double click: cut · Backspace: one corner back · %1 · Esc: leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut with scissors</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ShortcutsDialog</name>
    <message>
        <source>&amp;Assign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All &amp;standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New keys of the chosen command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the keys; Assign without any takes the command&apos;s keys away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keys that the command comes with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take &amp;over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has these keys. It loses them when you take them over.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::SliceCanvas</name>
    <message>
        <source>Slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axial slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys move the cross hairs by a voxel, Page Up and Page Down go to the next slices, plus and minus zoom, Home fits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: click to go there, wheel for the next slice, Ctrl and wheel to zoom, Shift and drag to measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::SlicesPanel</name>
    <message>
        <source>&amp;Look here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value and place of the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan&apos;s value at the cross hairs, and their place in patient coordinates (LPS, mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the point into the middle of the figure; views and turns go about it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 at %3, %4, %5 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::SliderRow</name>
    <message>
        <source>%1, number</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::StippleForm</name>
    <message>
        <source>The figure has no marks of ink. Switch them on, or take a ready-made look, to draw with dots, lines and strokes.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::StipplePart</name>
    <message>
        <source>Stipple “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset  </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a ready-made look; ink, dot size and how the dots stand to the layers stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take ink from style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use one ink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the tone follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing yet: all surfaces are as dark as dots can make them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines and strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots and layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots under the layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots over the layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dots alone: no layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The data as they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the layers show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fine points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evenly on paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evenly on the volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of inked paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the most dots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regression (Neumann)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Central differences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change seed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::StudioDocument</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::StyleCardForm</name>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ivory bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the gallery calls the style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bone, ink, warm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words between commas, to find it by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Credit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who made the artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Named in figures that use the style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Licence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Public domain, CC BY 4.0 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the artwork may be used for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add to my styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add and &amp;use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;redit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L&amp;icence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no style yet: draw a form on the artwork</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the style a name first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the style with your own; the dialog stays open for the next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the style and puts it on the chosen layer or style point</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::StyleDetails</name>
    <message>
        <source>One of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept in this project only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comes with Limner; duplicate it to change its card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show how the scan would look in the style that is pointed at or chosen, put where a click would put it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate to mine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a copy among your own styles, whose card you can change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the style from your own (Delete). It can be brought back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The style as a ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan in this style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the style is called</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words to find it by, with commas between them: bone, ink, warm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Credit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who made the artwork that it was taken from; figures name it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L&amp;icence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On what terms it may be used, such as “CC BY 4.0” or “public domain”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a style to see more of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan with %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::StyleDrop</name>
    <message>
        <source>other labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>label %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · around %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where a dragged style would go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing here to put a style onto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of %1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 → %2   (Shift: the whole layer)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking at the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding what is meant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace style</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::StyleGallery</name>
    <message>
        <source>★</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show favourites only. A click on a style&apos;s star, or Control D, makes it one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only styles that have these tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the chosen style&apos;s card: a larger ball, how the scan looks in it, its name, tags, credit and licence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a picture of a shaded ball (a lit sphere, a matcap) to your own styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From artwork…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a style from a scanned drawing or painting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words of a style&apos;s name or tags: bone, ink, glass …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Favourites only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Small balls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Medium balls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Large balls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scan to use styles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is locked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click replaces the selected style of &lt;b&gt;%1&lt;/b&gt;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click styles all of &lt;b&gt;%1&lt;/b&gt;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put onto the layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No favourite any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it a favourite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate to mine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tags: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only styles with: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No favourites yet. Click a style&apos;s star to make it one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No style has these words and tags.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point at a style to see it on the scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This layer cannot be changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scan first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::StyleShelf</name>
    <message>
        <source>Reading your styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeping favourites</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing a style&apos;s card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removing a style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bringing a style back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ThemeMenu</name>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ToneForm</name>
    <message>
        <source>Tone “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::TransferCanvas</name>
    <message>
        <source>Transfer function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity and style over the data value. Control with arrow keys goes from handle to handle, arrow keys move the handle, Insert adds a point, Delete removes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move opacity point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move opacity line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add opacity point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a step here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make opacity step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove opacity point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag points and styles. Double click adds a point, Delete or the right button removes. The wheel zooms, the middle button moves the ruler; a double click on the ruler shows the whole range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1%2, opacity %3 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a layer to shape its opacity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This layer&apos;s transfer function has two dimensions. It is kept as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing shows yet. Double click to add an opacity point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::TransferEditor1d</name>
    <message>
        <source>Add point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an opacity point after the selected one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the opacity jump at the selected point instead of rising towards it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected point or style (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value of the selected handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data value of the selected handle, in the volume&apos;s unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity of the selected point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity of the selected point, in percent for a thickness of one voxel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layer is locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing selected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::VariantDialog</name>
    <message>
        <source>Variants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other looks, or a number of the figure at several values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the chosen variant the figure (double click does it too)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Themes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scan first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A double click takes one; Undo gives it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing of this kind for this figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take variant %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::ViewForm</name>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The patient&apos;s front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The patient&apos;s back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The patient&apos;s left side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The patient&apos;s right side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From above the head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From below the feet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3/4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the front, turned and from a little above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill the sheet with what is visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round the patient, in degrees: 0 before the face, 90 at the patient&apos;s left side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the viewer, in degrees: 90 straight above, −90 straight below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lean of the picture, in degrees, counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn, tilt, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle, towards the patient&apos;s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle, towards the back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle, towards the head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move middle of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::Viewport</name>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figure. Arrow keys turn it, plus and minus zoom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn, drag with the middle button or Shift to move, wheel to zoom, double click to fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::WelcomePage</name>
    <message>
        <source>Limner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a CT or MR scan to a print-ready illustration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scan or project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a folder of slices…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try the sample head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A built-in head with skin, skull and vessels; nothing is downloaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or drop it here: a DICOM folder or file, NIfTI, NRRD, MetaImage, VTK, TIFF or PNG stacks, InVesalius, or a .limner project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::WindowBackground</name>
    <message>
        <source>Paper colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture behind the figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr);;Everything (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::WindowGallery</name>
    <message>
        <source>Added “%1” to your styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removed “%1” from your styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import pictures of shaded balls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.psd *.tga *.bmp *.webp);;Everything (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicating %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing the scan in a style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking at the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selected %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::WindowLooks</name>
    <message>
        <source>Keep this look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks and projects (*.limner *.json);;Everything (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeping the look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The look “%1” is kept: Looks, Mine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importing the look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removing the look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::WindowSlices</name>
    <message>
        <source>Slices</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::WindowStipple</name>
    <message>
        <source>Stipple</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::WindowView</name>
    <message>
        <source>View and cut</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>limner::WindowWorkspace</name>
    <message>
        <source>The layout “%1” is of another version of the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep this layout…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes when Limner is started again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Makes print-ready illustrations of CT and MR scans.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scan, a folder of slices, a project or a figure to open.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
