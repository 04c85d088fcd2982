<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>AccuracyWords</name>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>the step along the rays</source>
        <translation>die Schrittweite auf den Strahlen</translation>
    </message>
    <message>
        <source>pre-integration</source>
        <translation>die Vorintegration</translation>
    </message>
    <message>
        <source>the early end of the rays</source>
        <translation>das frühe Ende der Strahlen</translation>
    </message>
    <message>
        <source>the size of the tables</source>
        <translation>die Größe der Tabellen</translation>
    </message>
    <message>
        <source>the precision of the voxels</source>
        <translation>die Genauigkeit der Voxel</translation>
    </message>
    <message>
        <source>the interpolation</source>
        <translation>die Interpolation</translation>
    </message>
    <message>
        <source>the gradient</source>
        <translation>der Gradient</translation>
    </message>
    <message>
        <source>the number of rays per pixel</source>
        <translation>die Zahl der Strahlen je Pixel</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>full</source>
        <translation>voll</translation>
    </message>
    <message>
        <source>all it needs</source>
        <translation>so viel wie nötig</translation>
    </message>
    <message>
        <source>tricubic</source>
        <translation>trikubisch</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>of fourth order</source>
        <translation>vierter Ordnung</translation>
    </message>
    <message>
        <source>of a B-spline</source>
        <translation>eines B-Splines</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>Largest difference</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>Root mean square</source>
        <translation>Quadratisches Mittel</translation>
    </message>
    <message>
        <source>Colour difference (CIEDE2000)</source>
        <translation>Farbabstand (CIEDE2000)</translation>
    </message>
    <message>
        <source>ΔE %1</source>
        <translation>ΔE %1</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>step %1 voxel</source>
        <translation>Schritt %1 Voxel</translation>
    </message>
    <message>
        <source>pre-integrated</source>
        <translation>vorintegriert</translation>
    </message>
    <message>
        <source>rays end at %1</source>
        <translation>Strahlen enden bei %1</translation>
    </message>
    <message>
        <source>rays go on to their end</source>
        <translation>Strahlen gehen bis zum Ende</translation>
    </message>
    <message>
        <source>%1 rays per pixel</source>
        <translation>%1 Strahlen je Pixel</translation>
    </message>
    <message>
        <source>Pre-integration</source>
        <translation>Vorintegration</translation>
    </message>
    <message>
        <source>Point samples</source>
        <translation>Punktproben</translation>
    </message>
    <message>
        <source>As asked</source>
        <translation>Wie verlangt</translation>
    </message>
    <message>
        <source>Nothing that can be set makes the error smaller.</source>
        <translation>Nichts, was sich einstellen lässt, macht den Fehler kleiner.</translation>
    </message>
    <message>
        <source>What limits the error is %1: at its best (%2), %3 would be left.</source>
        <translation>Den Fehler begrenzt: %1. Auf bester Stufe (%2) bliebe %3.</translation>
    </message>
    <message>
        <source>Nothing is left out of this picture: it needs all that there is.</source>
        <translation>An diesem Bild ist nichts weggelassen: Es braucht alles, was da ist.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>All together: %1. The picture, %2 × %3 pixels, takes %4.</source>
        <translation>Alles zusammen: %1. Das Bild mit %2 × %3 Pixeln dauert %4.</translation>
    </message>
</context>
<context>
    <name>Actions</name>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen …</translation>
    </message>
    <message>
        <source>Open a scan, a project or a figure</source>
        <translation>Eine Aufnahme, ein Projekt oder eine Abbildung öffnen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open &amp;folder of slices…</source>
        <translation>Schichto&amp;rdner öffnen …</translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series or a stack of pictures</source>
        <translation>Einen Ordner mit einer DICOM-Serie oder einem Bilderstapel öffnen</translation>
    </message>
    <message>
        <source>Open &amp;labels…</source>
        <translation>&amp;Labels öffnen …</translation>
    </message>
    <message>
        <source>Open a volume of label numbers that belongs to the scan</source>
        <translation>Ein Volumen mit Labelnummern öffnen, das zur Aufnahme gehört</translation>
    </message>
    <message>
        <source>Open s&amp;ample head</source>
        <translation>Beispiel&amp;kopf öffnen</translation>
    </message>
    <message>
        <source>Open the built-in head, to try things out</source>
        <translation>Den eingebauten Kopf zum Ausprobieren öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Scans and projects that were open lately</source>
        <translation>Kürzlich geöffnete Aufnahmen und Projekte</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Das Projekt unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>&amp;Export picture…</source>
        <translation>Bild &amp;exportieren …</translation>
    </message>
    <message>
        <source>Write the figure as a picture with a size in millimetres</source>
        <translation>Die Abbildung als Bild mit einer Größe in Millimetern schreiben</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close the document</source>
        <translation>Das Dokument schließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Leave Limner Studio</source>
        <translation>Limner Studio verlassen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Repeat what was taken back</source>
        <translation>Das Zurückgenommene wiederholen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the shown picture to the clipboard</source>
        <translation>Das gezeigte Bild in die Zwischenablage kopieren</translation>
    </message>
    <message>
        <source>Add &amp;lens</source>
        <translation>&amp;Linse hinzufügen</translation>
    </message>
    <message>
        <source>Add a lens under which what matters shows through</source>
        <translation>Eine Linse hinzufügen, unter der das Wichtige hindurchscheint</translation>
    </message>
    <message>
        <source>St&amp;ipple</source>
        <translation>&amp;Punktieren</translation>
    </message>
    <message>
        <source>Draw the figure with dots and lines of ink, and show their panel</source>
        <translation>Die Abbildung mit Punkten und Linien aus Tinte zeichnen und deren Bedienfeld zeigen</translation>
    </message>
    <message>
        <source>&amp;Scissors</source>
        <translation>&amp;Schere</translation>
    </message>
    <message>
        <source>Cut away what an outline drawn in the picture encloses</source>
        <translation>Wegschneiden, was ein im Bild gezeichneter Umriss umschließt</translation>
    </message>
    <message>
        <source>&amp;Keep the island here</source>
        <translation>&amp;Insel hier behalten</translation>
    </message>
    <message>
        <source>Click on the part that stays; what is not connected with it goes</source>
        <translation>Auf den Teil klicken, der bleibt; was nicht mit ihm verbunden ist, verschwindet</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Click on two places of the figure: how far they are from each other</source>
        <translation>Auf zwei Stellen der Abbildung klicken: wie weit sie voneinander entfernt sind</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>&amp;Anterior</translation>
    </message>
    <message>
        <source>Look at the patient&apos;s front</source>
        <translation>Den Patienten von vorn ansehen</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>&amp;Posterior</translation>
    </message>
    <message>
        <source>Look at the patient&apos;s back</source>
        <translation>Den Patienten von hinten ansehen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Look at the patient&apos;s left side</source>
        <translation>Den Patienten von seiner linken Seite ansehen</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>Look at the patient&apos;s right side</source>
        <translation>Den Patienten von seiner rechten Seite ansehen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>&amp;Superior</translation>
    </message>
    <message>
        <source>Look from above the head</source>
        <translation>Von oben auf den Kopf blicken</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>&amp;Inferior</translation>
    </message>
    <message>
        <source>Look from below the feet</source>
        <translation>Von unterhalb der Füße blicken</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>&amp;Three-quarter</source>
        <translation>&amp;Dreiviertelansicht</translation>
    </message>
    <message>
        <source>Look from the front, turned and from a little above</source>
        <translation>Von vorn blicken, gedreht und leicht von oben</translation>
    </message>
    <message>
        <source>3/4</source>
        <translation>3/4</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Fill the sheet with what is visible</source>
        <translation>Das Blatt mit dem füllen, was sichtbar ist</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Show a smaller part, larger</source>
        <translation>Einen kleineren Teil größer zeigen</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Show more, smaller</source>
        <translation>Mehr zeigen, kleiner</translation>
    </message>
    <message>
        <source>Turn freel&amp;y</source>
        <translation>&amp;Frei drehen</translation>
    </message>
    <message>
        <source>Turn about any axis instead of keeping the horizon level</source>
        <translation>Um jede Achse drehen, statt den Horizont waagerecht zu halten</translation>
    </message>
    <message>
        <source>&amp;Variants…</source>
        <translation>Va&amp;rianten …</translation>
    </message>
    <message>
        <source>A sheet of the figure in other looks, or with a setting at several values; take one</source>
        <translation>Ein Blatt der Abbildung in anderen Looks oder mit einer Einstellung in mehreren Werten; eine davon nehmen</translation>
    </message>
    <message>
        <source>&amp;Mine</source>
        <translation>&amp;Eigene</translation>
    </message>
    <message>
        <source>Lay a look of your own over the figure</source>
        <translation>Einen eigenen Look auf die Abbildung legen</translation>
    </message>
    <message>
        <source>&amp;Keep this look…</source>
        <translation>Diesen Look &amp;behalten …</translation>
    </message>
    <message>
        <source>Keep styles, layers and ink of this figure under a name, for other scans</source>
        <translation>Stile, Ebenen und Tinte dieser Abbildung unter einem Namen für andere Aufnahmen behalten</translation>
    </message>
    <message>
        <source>&amp;Import look…</source>
        <translation>Look &amp;importieren …</translation>
    </message>
    <message>
        <source>Take the look of a file or of a project into your own looks</source>
        <translation>Den Look einer Datei oder eines Projekts zu den eigenen Looks nehmen</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Ent&amp;fernen</translation>
    </message>
    <message>
        <source>Delete one of your own looks</source>
        <translation>Einen der eigenen Looks löschen</translation>
    </message>
    <message>
        <source>&amp;Find a style</source>
        <translation>Stil &amp;suchen</translation>
    </message>
    <message>
        <source>Search the gallery of styles</source>
        <translation>Die Stilgalerie durchsuchen</translation>
    </message>
    <message>
        <source>&amp;Import picture…</source>
        <translation>Bild &amp;importieren …</translation>
    </message>
    <message>
        <source>Add a picture of a shaded ball to your own styles</source>
        <translation>Das Bild einer schattierten Kugel zu den eigenen Stilen hinzufügen</translation>
    </message>
    <message>
        <source>Take from &amp;artwork…</source>
        <translation>Aus &amp;Kunstwerk übernehmen …</translation>
    </message>
    <message>
        <source>Take a style from a scanned drawing or painting</source>
        <translation>Einen Stil aus einer eingescannten Zeichnung oder Malerei übernehmen</translation>
    </message>
    <message>
        <source>Paper &amp;colour…</source>
        <translation>Papier&amp;farbe …</translation>
    </message>
    <message>
        <source>Lay the figure on a plain paper of a colour</source>
        <translation>Die Abbildung auf einfarbiges Papier legen</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>&amp;Bild …</translation>
    </message>
    <message>
        <source>Lay the figure over a picture, an artwork or a sheet of paper</source>
        <translation>Die Abbildung über ein Bild, ein Kunstwerk oder einen Papierbogen legen</translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation>&amp;Befehle …</translation>
    </message>
    <message>
        <source>Find any command by its name and do it</source>
        <translation>Einen beliebigen Befehl nach seinem Namen finden und ausführen</translation>
    </message>
    <message>
        <source>&amp;Shortcuts…</source>
        <translation>&amp;Tastenkürzel …</translation>
    </message>
    <message>
        <source>See and change the keys of all commands</source>
        <translation>Die Tasten aller Befehle sehen und ändern</translation>
    </message>
    <message>
        <source>&amp;Layouts</source>
        <translation>&amp;Anordnungen</translation>
    </message>
    <message>
        <source>Arrangements of the panels</source>
        <translation>Anordnungen der Bedienfelder</translation>
    </message>
    <message>
        <source>Co&amp;lours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Light or dark colours of the window</source>
        <translation>Helle oder dunkle Farben des Fensters</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Language of the window; the change shows at the next start</source>
        <translation>Sprache des Fensters; die Änderung gilt ab dem nächsten Start</translation>
    </message>
    <message>
        <source>Only the &amp;picture</source>
        <translation>Nur das Bil&amp;d</translation>
    </message>
    <message>
        <source>Hide all panels, or bring them back</source>
        <translation>Alle Bedienfelder verbergen oder zurückholen</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Use the whole screen, or the window again</source>
        <translation>Den ganzen Bildschirm nutzen oder wieder das Fenster</translation>
    </message>
    <message>
        <source>&amp;About Limner</source>
        <translation>Ü&amp;ber Limner</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>Save a cop&amp;y…</source>
        <translation>Kop&amp;ie speichern …</translation>
    </message>
    <message>
        <source>Save the project as it is under another name, and go on with this</source>
        <translation>Das Projekt, wie es ist, unter einem anderen Namen speichern und mit diesem weiterarbeiten</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Auf &amp;gespeicherten Stand zurücksetzen</translation>
    </message>
    <message>
        <source>The figure as it was saved last; Undo brings the changes back</source>
        <translation>Die Abbildung, wie sie zuletzt gespeichert wurde; Rückgängig holt die Änderungen zurück</translation>
    </message>
    <message>
        <source>&amp;Pack the scan into the project</source>
        <translation>Aufnahme ins &amp;Projekt packen</translation>
    </message>
    <message>
        <source>Keep the scan inside the project file, so that it can be moved and sent alone</source>
        <translation>Die Aufnahme in der Projektdatei halten, sodass diese sich allein verschieben und versenden lässt</translation>
    </message>
    <message>
        <source>&amp;Name this state…</source>
        <translation>Diesen Stand be&amp;nennen …</translation>
    </message>
    <message>
        <source>Keep the figure as it is now under a name, to come back to it</source>
        <translation>Die jetzige Abbildung unter einem Namen behalten, um darauf zurückzukommen</translation>
    </message>
    <message>
        <source>Add la&amp;bel</source>
        <translation>&amp;Beschriftung hinzufügen</translation>
    </message>
    <message>
        <source>Click on a structure in the picture and write its name</source>
        <translation>Auf eine Struktur im Bild klicken und ihren Namen schreiben</translation>
    </message>
    <message>
        <source>&amp;Widen the opacity&apos;s range</source>
        <translation>&amp;Deckkraftbereich erweitern</translation>
    </message>
    <message>
        <source>Drag over a structure in the picture: the chosen layer comes to show its values</source>
        <translation>Über eine Struktur im Bild ziehen: Die gewählte Ebene zeigt dann auch ihre Werte</translation>
    </message>
    <message>
        <source>Pictures dra&amp;wn by</source>
        <translation>Bilder &amp;gezeichnet von</translation>
    </message>
    <message>
        <source>What draws the pictures: a graphics card by OpenGL, or the processor; the change shows at the next start</source>
        <translation>Was die Bilder zeichnet: eine Grafikkarte mit OpenGL oder der Prozessor; die Änderung gilt ab dem nächsten Start</translation>
    </message>
    <message>
        <source>Find settings for the &amp;accuracy</source>
        <translation>Einstellungen für die &amp;Genauigkeit finden</translation>
    </message>
    <message>
        <source>Find the settings that keep the chosen error in the least time, and set them</source>
        <translation>Die Einstellungen, die den gewählten Fehler in der kürzesten Zeit einhalten, finden und setzen</translation>
    </message>
    <message>
        <source>Show &amp;error over the picture</source>
        <translation>F&amp;ehler über dem Bild zeigen</translation>
    </message>
    <message>
        <source>Lay over the picture how far each pixel is off, until the figure or the view changes</source>
        <translation>Über das Bild legen, wie weit jedes Pixel daneben liegt, bis sich Figur oder Ansicht ändern</translation>
    </message>
</context>
<context>
    <name>Axes</name>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Second scan</source>
        <translation>Zweite Aufnahme</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Wichtigkeit</translation>
    </message>
    <message>
        <source>This scan has no labels: open a label volume (File, Open labels) or take another axis.</source>
        <translation>Diese Aufnahme hat keine Labels: ein Labelvolumen öffnen (Datei, Labels öffnen) oder eine andere Achse wählen.</translation>
    </message>
    <message>
        <source>This figure has no second scan: give it one, or take another axis.</source>
        <translation>Diese Abbildung hat keine zweite Aufnahme: eine angeben oder eine andere Achse wählen.</translation>
    </message>
    <message>
        <source>This figure weighs nothing by importance: set a measure in the Importance panel, or take another axis.</source>
        <translation>Diese Abbildung gewichtet nichts nach Wichtigkeit: im Bedienfeld Wichtigkeit ein Maß angeben oder eine andere Achse wählen.</translation>
    </message>
    <message>
        <source>Show more of the axis (−)</source>
        <translation>Mehr von der Achse zeigen (−)</translation>
    </message>
    <message>
        <source>Show less of the axis, larger (+)</source>
        <translation>Weniger von der Achse zeigen, größer (+)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the values that nearly all voxels have, rare ones left out (Home)</source>
        <translation>Die Werte zeigen, die fast alle Voxel haben, seltene ausgelassen (Pos1)</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Show all values of the scan, the rarest too</source>
        <translation>Alle Werte der Aufnahme zeigen, auch die seltensten</translation>
    </message>
</context>
<context>
    <name>CleanupWords</name>
    <message>
        <source>Erase %1 (label %2)</source>
        <translation>%1 löschen (Label %2)</translation>
    </message>
    <message>
        <source>Erase label %1</source>
        <translation>Label %1 löschen</translation>
    </message>
    <message>
        <source>Keep the largest island</source>
        <translation>Die größte Insel behalten</translation>
    </message>
    <message>
        <source>Keep the island at a point</source>
        <translation>Die Insel an einem Punkt behalten</translation>
    </message>
    <message>
        <source>Remove small islands</source>
        <translation>Kleine Inseln entfernen</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Erase a label</source>
        <translation>Ein Label löschen</translation>
    </message>
    <message>
        <source>Keep the largest island above %1, parted where thinner than %2 mm</source>
        <translation>Die größte Insel über %1 behalten, getrennt, wo sie dünner als %2 mm ist</translation>
    </message>
    <message>
        <source>Keep the largest island above %1</source>
        <translation>Die größte Insel über %1 behalten</translation>
    </message>
    <message>
        <source>Keep the island above %1 at %2, %3, %4 mm</source>
        <translation>Die Insel über %1 bei %2, %3, %4 mm behalten</translation>
    </message>
    <message>
        <source>Remove islands above %1 that are smaller than %2 mm³</source>
        <translation>Inseln über %1 entfernen, die kleiner als %2 mm³ sind</translation>
    </message>
    <message>
        <source>Scissors: %1 points, %2</source>
        <translation>Schere: %1 Punkte, %2</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>0: not seen.</source>
        <translation>0: nicht zu sehen.</translation>
    </message>
    <message>
        <source>A CT whose values were cut to 8 bits: soft tissue, blood and bone by brightness.</source>
        <translation>Ein CT, dessen Werte auf 8 Bit gekürzt wurden: Weichteile, Blut und Knochen nach Helligkeit.</translation>
    </message>
    <message>
        <source>A casting or assembly: a glassy body around its dense parts, steel and brass.</source>
        <translation>Ein Gussteil oder eine Baugruppe: ein gläserner Körper um seine dichten Teile, Stahl und Messing.</translation>
    </message>
    <message>
        <source>A colour or a picture behind the figure.</source>
        <translation>Eine Farbe oder ein Bild hinter der Abbildung.</translation>
    </message>
    <message>
        <source>A few slices of a CT as an anatomical section: fat, muscle, organs, blood and bone.</source>
        <translation>Wenige Schichten eines CT als anatomischer Schnitt: Fett, Muskeln, Organe, Blut und Knochen.</translation>
    </message>
    <message>
        <source>A head CT with glassy skin over an ivory skull.</source>
        <translation>Ein Kopf-CT mit gläserner Haut über einem elfenbeinfarbenen Schädel.</translation>
    </message>
    <message>
        <source>A micro-CT of a tooth: dentine and enamel.</source>
        <translation>Ein Mikro-CT eines Zahns: Dentin und Schmelz.</translation>
    </message>
    <message>
        <source>A picture laid on the object, apart from the lighting.</source>
        <translation>Ein Bild, das unabhängig von der Beleuchtung auf dem Objekt liegt.</translation>
    </message>
    <message>
        <source>A point of the island that stays.</source>
        <translation>Ein Punkt der Insel, die bleibt.</translation>
    </message>
    <message>
        <source>A point of the scan that the lens follows as the view turns.</source>
        <translation>Ein Punkt der Aufnahme, dem die Linse folgt, wenn sich die Ansicht dreht.</translation>
    </message>
    <message>
        <source>A ray ends where less than this share of light is left; 0: never.</source>
        <translation>Ein Strahl endet, wo weniger als dieser Anteil des Lichts übrig ist; 0: nie.</translation>
    </message>
    <message>
        <source>A seam that parts what is in front from what is behind.</source>
        <translation>Ein Saum, der trennt, was vorn und was hinten liegt.</translation>
    </message>
    <message>
        <source>A single slice head on, in greys.</source>
        <translation>Eine einzelne Schicht von vorn, in Graustufen.</translation>
    </message>
    <message>
        <source>A soft shadow on what lies close behind.</source>
        <translation>Ein weicher Schatten auf dem, was dicht dahinter liegt.</translation>
    </message>
    <message>
        <source>Accuracy against time.</source>
        <translation>Genauigkeit gegen Zeit.</translation>
    </message>
    <message>
        <source>Aerial perspective</source>
        <translation>Luftperspektive</translation>
    </message>
    <message>
        <source>Along the first axis</source>
        <translation>Entlang der ersten Achse</translation>
    </message>
    <message>
        <source>Along the second axis</source>
        <translation>Entlang der zweiten Achse</translation>
    </message>
    <message>
        <source>Along the view, or along an axis of the patient.</source>
        <translation>Entlang der Blickrichtung oder einer Achse des Patienten.</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Umgebungslicht</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>Ambient occlusion, contact shadow and halos.</source>
        <translation>Umgebungsverdeckung, Kontaktschatten und Halos.</translation>
    </message>
    <message>
        <source>An MR head cut level above the eyes: skin outside, the brain&apos;s section inside.</source>
        <translation>Ein MR-Kopf, waagerecht über den Augen geschnitten: außen die Haut, innen der Schnitt durch das Gehirn.</translation>
    </message>
    <message>
        <source>Anchor</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Another number spreads the dots otherwise.</source>
        <translation>Eine andere Zahl verteilt die Punkte anders.</translation>
    </message>
    <message>
        <source>Another scan on the same grid, for two-dimensional transfer functions.</source>
        <translation>Eine weitere Aufnahme auf demselben Gitter, für zweidimensionale Transferfunktionen.</translation>
    </message>
    <message>
        <source>Any scan with a boundary: the surface in warm wax, dense matter in ivory.</source>
        <translation>Jede Aufnahme mit einer Grenzfläche: die Oberfläche in warmem Wachs, dichte Materie in Elfenbein.</translation>
    </message>
    <message>
        <source>Arteries of an angiography, or contrast-filled vessels of a CT.</source>
        <translation>Arterien einer Angiografie oder kontrastmittelgefüllte Gefäße eines CT.</translation>
    </message>
    <message>
        <source>As a share of the figure&apos;s height.</source>
        <translation>Als Anteil der Höhe der Abbildung.</translation>
    </message>
    <message>
        <source>As they are, or drawn from a copy in the 256 levels that fit the scan best: half as large, at an error that is shown.</source>
        <translation>Unverändert, oder gezeichnet aus einer Kopie in den 256 Stufen, die am besten zur Aufnahme passen: halb so groß, mit einem Fehler, der angezeigt wird.</translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation>Seitenverhältnis</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Between voxels.</source>
        <translation>Zwischen den Voxeln.</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>Wandtafel</translation>
    </message>
    <message>
        <source>Blue shade turns smoothly into warm light.</source>
        <translation>Blauer Schatten geht weich in warmes Licht über.</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Unschärfe</translation>
    </message>
    <message>
        <source>Bound of the Laplacian of Gaussian for a line.</source>
        <translation>Schwelle des Laplacian of Gaussian für eine Linie.</translation>
    </message>
    <message>
        <source>Boundaries and silhouettes</source>
        <translation>Grenzflächen und Silhouetten</translation>
    </message>
    <message>
        <source>Boundaries matter.</source>
        <translation>Grenzflächen sind wichtig.</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Grenzfläche</translation>
    </message>
    <message>
        <source>Brain (MR)</source>
        <translation>Gehirn (MR)</translation>
    </message>
    <message>
        <source>Bright data matter.</source>
        <translation>Helle Daten sind wichtig.</translation>
    </message>
    <message>
        <source>Brown shade and creamy light, as in a wash drawing.</source>
        <translation>Brauner Schatten und cremefarbenes Licht wie in einer Lavierung.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Cartoon</source>
        <translation>Cartoon</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Rasterzelle</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Check sum</source>
        <translation>Prüfsumme</translation>
    </message>
    <message>
        <source>Clean airbrushed tissue in the colours of today&apos;s atlases, on white.</source>
        <translation>Sauber gespritztes Gewebe in den Farben heutiger Atlanten, auf Weiß.</translation>
    </message>
    <message>
        <source>Clean-up</source>
        <translation>Bereinigung</translation>
    </message>
    <message>
        <source>Clip box</source>
        <translation>Ausschnittquader</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>Schnittebenen</translation>
    </message>
    <message>
        <source>Clipping</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour and opacity of the paper.</source>
        <translation>Farbe und Deckkraft des Papiers.</translation>
    </message>
    <message>
        <source>Colour at the key.</source>
        <translation>Farbe am Stützpunkt.</translation>
    </message>
    <message>
        <source>Colour by position</source>
        <translation>Farbe nach Lage</translation>
    </message>
    <message>
        <source>Colour of each label number, as #rrggbb.</source>
        <translation>Farbe jeder Labelnummer als #rrggbb.</translation>
    </message>
    <message>
        <source>Colour of the dots.</source>
        <translation>Farbe der Punkte.</translation>
    </message>
    <message>
        <source>Colour of the outline.</source>
        <translation>Farbe des Umrisses.</translation>
    </message>
    <message>
        <source>Colour of the seam: dark, or the paper&apos;s.</source>
        <translation>Farbe des Saums: dunkel oder die des Papiers.</translation>
    </message>
    <message>
        <source>Colour ramp from shade to light.</source>
        <translation>Farbverlauf vom Schatten zum Licht.</translation>
    </message>
    <message>
        <source>Coloured chalk on a dark board, as drawn in the lecture.</source>
        <translation>Farbige Kreide auf dunkler Tafel, wie in der Vorlesung gezeichnet.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Contact shadow</source>
        <translation>Kontaktschatten</translation>
    </message>
    <message>
        <source>Contour thickness</source>
        <translation>Konturstärke</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>Contrast-filled heart and great vessels with the bones around them, from a CT angiography.</source>
        <translation>Kontrastmittelgefülltes Herz und große Gefäße mit den umgebenden Knochen, aus einer CT-Angiografie.</translation>
    </message>
    <message>
        <source>Cool to warm</source>
        <translation>Kalt nach warm</translation>
    </message>
    <message>
        <source>Credit</source>
        <translation>Urheber</translation>
    </message>
    <message>
        <source>Crossing</source>
        <translation>Kreuzen</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Wegschneiden</translation>
    </message>
    <message>
        <source>Cut faces</source>
        <translation>Schnittflächen</translation>
    </message>
    <message>
        <source>Cuts are drawn flat, in a style of their own or the layer&apos;s.</source>
        <translation>Schnitte werden flächig gezeichnet, in einem eigenen Stil oder dem der Ebene.</translation>
    </message>
    <message>
        <source>DICOM series where the folder holds several.</source>
        <translation>DICOM-Serie, wenn der Ordner mehrere enthält.</translation>
    </message>
    <message>
        <source>Darkening</source>
        <translation>Abdunklung</translation>
    </message>
    <message>
        <source>Data value of the node.</source>
        <translation>Datenwert des Knotens.</translation>
    </message>
    <message>
        <source>Deep blue shade under pale moonlight.</source>
        <translation>Tiefblauer Schatten unter blassem Mondlicht.</translation>
    </message>
    <message>
        <source>Dense matter matters.</source>
        <translation>Dichte Materie ist wichtig.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Depth cues</source>
        <translation>Tiefenhinweise</translation>
    </message>
    <message>
        <source>Depth fade</source>
        <translation>Tiefenverblassen</translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation>Tiefenunschärfe</translation>
    </message>
    <message>
        <source>Depth that is sharp, from the front (0) to the back (1).</source>
        <translation>Tiefe, die scharf ist, von vorn (0) bis hinten (1).</translation>
    </message>
    <message>
        <source>Diameter of the largest dots on paper.</source>
        <translation>Durchmesser der größten Punkte auf dem Papier.</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Diffus</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction to the light: right, up, towards the viewer.</source>
        <translation>Richtung zum Licht: rechts, oben, zum Betrachter.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance from</source>
        <translation>Abstand von</translation>
    </message>
    <message>
        <source>Distance of samples on a ray, in smallest voxel spacings.</source>
        <translation>Abstand der Abtastpunkte auf einem Strahl, in kleinsten Voxelabständen.</translation>
    </message>
    <message>
        <source>Distance over which the curvature is measured.</source>
        <translation>Strecke, über die die Krümmung gemessen wird.</translation>
    </message>
    <message>
        <source>Dot size</source>
        <translation>Punktgröße</translation>
    </message>
    <message>
        <source>Dots behind matter are removed or shown.</source>
        <translation>Punkte hinter Materie werden entfernt oder gezeigt.</translation>
    </message>
    <message>
        <source>Dots gather on boundaries and where surfaces turn away, with lines along the silhouettes.</source>
        <translation>Punkte sammeln sich an Grenzflächen und dort, wo Oberflächen sich abwenden, mit Linien entlang der Silhouetten.</translation>
    </message>
    <message>
        <source>Dots lie evenly on paper, or on the volume, where they stay when it turns (a moving picture&apos;s always do).</source>
        <translation>Punkte liegen gleichmäßig auf dem Papier oder auf dem Volumen, wo sie beim Drehen bleiben (bei bewegten Bildern immer).</translation>
    </message>
    <message>
        <source>Dots lie in the shade; what faces the light stays paper.</source>
        <translation>Punkte liegen im Schatten; was dem Licht zugewandt ist, bleibt Papier.</translation>
    </message>
    <message>
        <source>Dots lie over the drawn layers or under their opacity, or alone: the layers are not drawn.</source>
        <translation>Punkte liegen über den gezeichneten Ebenen oder unter deren Deckkraft, oder allein: Die Ebenen werden nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Dots of ink.</source>
        <translation>Punkte aus Tinte.</translation>
    </message>
    <message>
        <source>Dots on every surface alike, the more the sharper it is.</source>
        <translation>Punkte auf jeder Oberfläche gleichermaßen, umso mehr, je schärfer sie ist.</translation>
    </message>
    <message>
        <source>Dots take the colour of the style under them.</source>
        <translation>Punkte nehmen die Farbe des Stils unter ihnen an.</translation>
    </message>
    <message>
        <source>Dots that a full boundary adds.</source>
        <translation>Punkte, die eine volle Grenzfläche hinzufügt.</translation>
    </message>
    <message>
        <source>Dots that the silhouette adds.</source>
        <translation>Punkte, die die Silhouette hinzufügt.</translation>
    </message>
    <message>
        <source>Dots where the surface faces the viewer.</source>
        <translation>Punkte, wo die Oberfläche dem Betrachter zugewandt ist.</translation>
    </message>
    <message>
        <source>Dots without any boundary.</source>
        <translation>Punkte ohne jede Grenzfläche.</translation>
    </message>
    <message>
        <source>Drawn styles, Phong&apos;s light, or flat colour.</source>
        <translation>Gezeichnete Stile, Phong-Licht oder reine Farbe.</translation>
    </message>
    <message>
        <source>Each label of a label volume in its own colour, with thin contours.</source>
        <translation>Jedes Label eines Labelvolumens in eigener Farbe, mit feinen Konturen.</translation>
    </message>
    <message>
        <source>Early end</source>
        <translation>Frühes Ende</translation>
    </message>
    <message>
        <source>Edge of the lens: hard, soft or a screen of dots.</source>
        <translation>Rand der Linse: hart, weich oder ein Raster aus Punkten.</translation>
    </message>
    <message>
        <source>Edge of the tile on the object.</source>
        <translation>Kante der Kachel auf dem Objekt.</translation>
    </message>
    <message>
        <source>Edge threshold</source>
        <translation>Kantenschwelle</translation>
    </message>
    <message>
        <source>Embedded</source>
        <translation>Eingebettet</translation>
    </message>
    <message>
        <source>Even width</source>
        <translation>Gleiche Breite</translation>
    </message>
    <message>
        <source>Even, or thinner where the form is flat (curvature) or far (depth).</source>
        <translation>Gleichmäßig oder dünner, wo die Form flach (Krümmung) oder fern (Tiefe) ist.</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>Exponent of the highlight&apos;s part.</source>
        <translation>Exponent des Glanzlichtanteils.</translation>
    </message>
    <message>
        <source>Exponent of the lit flats&apos; part.</source>
        <translation>Exponent des Anteils beleuchteter Flächen.</translation>
    </message>
    <message>
        <source>Exponent of the part without boundary.</source>
        <translation>Exponent des Anteils ohne Grenzfläche.</translation>
    </message>
    <message>
        <source>Extinction</source>
        <translation>Extinktion</translation>
    </message>
    <message>
        <source>Eye threshold</source>
        <translation>Blickschwelle</translation>
    </message>
    <message>
        <source>Factor of the importance away from the lens.</source>
        <translation>Faktor der Wichtigkeit abseits der Linse.</translation>
    </message>
    <message>
        <source>Factor of the importance in the middle of the lens.</source>
        <translation>Faktor der Wichtigkeit in der Mitte der Linse.</translation>
    </message>
    <message>
        <source>Factor on the number of dots; 0: no dots.</source>
        <translation>Faktor für die Zahl der Punkte; 0: keine Punkte.</translation>
    </message>
    <message>
        <source>Factors of red, green, blue and opacity; above 1 brightens.</source>
        <translation>Faktoren für Rot, Grün, Blau und Deckkraft; über 1 hellt auf.</translation>
    </message>
    <message>
        <source>Fewer dots in the light.</source>
        <translation>Weniger Punkte im Licht.</translation>
    </message>
    <message>
        <source>Fewer dots inside matter.</source>
        <translation>Weniger Punkte im Inneren von Materie.</translation>
    </message>
    <message>
        <source>Fewer dots where the volume looks smaller.</source>
        <translation>Weniger Punkte, wo das Volumen kleiner erscheint.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>File or folder of the scan, relative to the project.</source>
        <translation>Datei oder Ordner der Aufnahme, relativ zum Projekt.</translation>
    </message>
    <message>
        <source>File size</source>
        <translation>Dateigröße</translation>
    </message>
    <message>
        <source>First axis</source>
        <translation>Erste Achse</translation>
    </message>
    <message>
        <source>Fixed to the viewer&apos;s head, or to the object.</source>
        <translation>Fest zum Kopf des Betrachters oder zum Objekt.</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Four flat tones with three hard steps between them.</source>
        <translation>Vier flächige Töne mit drei harten Stufen dazwischen.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From full to none, by the cosine between normal and view.</source>
        <translation>Von voll bis keine, nach dem Kosinus zwischen Normale und Blickrichtung.</translation>
    </message>
    <message>
        <source>From no outline to all of one, by 1 less the cosine of normal and view.</source>
        <translation>Von keinem bis zum ganzen Umriss, nach 1 minus dem Kosinus von Normale und Blickrichtung.</translation>
    </message>
    <message>
        <source>From the object towards the light.</source>
        <translation>Vom Objekt zum Licht.</translation>
    </message>
    <message>
        <source>From where the figure is seen.</source>
        <translation>Von wo aus die Abbildung gesehen wird.</translation>
    </message>
    <message>
        <source>Full vertical angle of a perspective view.</source>
        <translation>Voller senkrechter Winkel einer perspektivischen Ansicht.</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Gradient threshold</source>
        <translation>Gradientenschwelle</translation>
    </message>
    <message>
        <source>Graphite study</source>
        <translation>Grafitstudie</translation>
    </message>
    <message>
        <source>Gray&apos;s engraving</source>
        <translation>Gray’scher Stich</translation>
    </message>
    <message>
        <source>Greatest importance: at 8, matter needs an opacity of 0.03 % to show through all that is in front; at 20 the faintest haze does.</source>
        <translation>Größte Wichtigkeit: Bei 8 braucht Materie eine Deckkraft von 0,03 %, um durch alles davor hindurchzuscheinen; bei 20 genügt der feinste Dunst.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Grundanteil</translation>
    </message>
    <message>
        <source>Haeckel</source>
        <translation>Haeckel</translation>
    </message>
    <message>
        <source>Half spaces that are cut away.</source>
        <translation>Halbräume, die weggeschnitten werden.</translation>
    </message>
    <message>
        <source>Half the angle under which the light is seen.</source>
        <translation>Halber Winkel, unter dem das Licht zu sehen ist.</translation>
    </message>
    <message>
        <source>Halos</source>
        <translation>Halos</translation>
    </message>
    <message>
        <source>Hatching</source>
        <translation>Schraffur</translation>
    </message>
    <message>
        <source>Heart and aorta</source>
        <translation>Herz und Aorta</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height of the printed figure.</source>
        <translation>Höhe der gedruckten Abbildung.</translation>
    </message>
    <message>
        <source>Height of what the picture shows at the target.</source>
        <translation>Höhe dessen, was das Bild am Zielpunkt zeigt.</translation>
    </message>
    <message>
        <source>Hidden dots</source>
        <translation>Verdeckte Punkte</translation>
    </message>
    <message>
        <source>Hidden lines</source>
        <translation>Verdeckte Linien</translation>
    </message>
    <message>
        <source>Highlight</source>
        <translation>Glanzlicht</translation>
    </message>
    <message>
        <source>Highlights</source>
        <translation>Glanzlichter</translation>
    </message>
    <message>
        <source>Highlights as of a wet or polished surface.</source>
        <translation>Glanzlichter wie auf einer nassen oder polierten Oberfläche.</translation>
    </message>
    <message>
        <source>Hollows and crevices are darker.</source>
        <translation>Mulden und Spalten sind dunkler.</translation>
    </message>
    <message>
        <source>How dark hollows get; 0: not at all.</source>
        <translation>Wie dunkel Mulden werden; 0: gar nicht.</translation>
    </message>
    <message>
        <source>How dark outlines are drawn; 0: not at all.</source>
        <translation>Wie dunkel Umrisse gezeichnet werden; 0: gar nicht.</translation>
    </message>
    <message>
        <source>How dark the shadow is.</source>
        <translation>Wie dunkel der Schatten ist.</translation>
    </message>
    <message>
        <source>How far around a place its statistics are taken.</source>
        <translation>Wie weit um eine Stelle ihre Statistik erhoben wird.</translation>
    </message>
    <message>
        <source>How far around a place matter takes its light.</source>
        <translation>Wie weit um eine Stelle Materie ihr Licht nimmt.</translation>
    </message>
    <message>
        <source>How far behind the seam reaches its full width.</source>
        <translation>Wie weit dahinter der Saum seine volle Breite erreicht.</translation>
    </message>
    <message>
        <source>How far dots lie around the surface.</source>
        <translation>Wie weit um die Oberfläche Punkte liegen.</translation>
    </message>
    <message>
        <source>How far the interior of matter is cleared of dots.</source>
        <translation>Wie weit das Innere von Materie von Punkten frei bleibt.</translation>
    </message>
    <message>
        <source>How far things cast their shadow.</source>
        <translation>Wie weit Dinge ihren Schatten werfen.</translation>
    </message>
    <message>
        <source>How fast dots thin out with distance from the viewer.</source>
        <translation>Wie schnell die Punkte mit dem Abstand vom Betrachter spärlicher werden.</translation>
    </message>
    <message>
        <source>How fast the layer blurs away from the focus.</source>
        <translation>Wie schnell die Ebene abseits des Fokus unscharf wird.</translation>
    </message>
    <message>
        <source>How much an outline&apos;s boundary must stand out.</source>
        <translation>Wie stark sich die Grenzfläche eines Umrisses abheben muss.</translation>
    </message>
    <message>
        <source>How much importance overrules what lies in front; 0: not at all.</source>
        <translation>Wie stark Wichtigkeit sich über das hinwegsetzt, was davor liegt; 0: gar nicht.</translation>
    </message>
    <message>
        <source>How much of what lies behind the halo hides.</source>
        <translation>Wie viel der Halo von dem verbirgt, was dahinter liegt.</translation>
    </message>
    <message>
        <source>How much the object matters.</source>
        <translation>Wie wichtig das Objekt ist.</translation>
    </message>
    <message>
        <source>How sharp a ridge must be for a line; 0: no ridges.</source>
        <translation>Wie scharf ein Grat für eine Linie sein muss; 0: keine Grate.</translation>
    </message>
    <message>
        <source>How sharp a valley must be for a line; 0: no valleys.</source>
        <translation>Wie scharf ein Tal für eine Linie sein muss; 0: keine Täler.</translation>
    </message>
    <message>
        <source>How sharply boundaries count.</source>
        <translation>Wie scharf Grenzflächen zählen.</translation>
    </message>
    <message>
        <source>How sharply lit parts are cleared of dots.</source>
        <translation>Wie scharf beleuchtete Teile von Punkten frei bleiben.</translation>
    </message>
    <message>
        <source>How sharply the silhouette counts.</source>
        <translation>Wie scharf die Silhouette zählt.</translation>
    </message>
    <message>
        <source>How surface directions are measured.</source>
        <translation>Wie Oberflächenrichtungen gemessen werden.</translation>
    </message>
    <message>
        <source>How surfaces are found: by regression over 27 voxels (Neumann), or by central differences.</source>
        <translation>Wie Oberflächen gefunden werden: durch Regression über 27 Voxel (Neumann) oder durch zentrale Differenzen.</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Id of a style in the figure&apos;s list.</source>
        <translation>Kennung eines Stils in der Liste der Abbildung.</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Wichtigkeit</translation>
    </message>
    <message>
        <source>Importance of labelled objects.</source>
        <translation>Wichtigkeit der Objekte mit Label.</translation>
    </message>
    <message>
        <source>Importance of the paper.</source>
        <translation>Wichtigkeit des Papiers.</translation>
    </message>
    <message>
        <source>In figure coordinates.</source>
        <translation>In Koordinaten der Abbildung.</translation>
    </message>
    <message>
        <source>Industrial part</source>
        <translation>Industriebauteil</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinte</translation>
    </message>
    <message>
        <source>Ink from style</source>
        <translation>Tinte aus dem Stil</translation>
    </message>
    <message>
        <source>Ink plate</source>
        <translation>Tintenauszug</translation>
    </message>
    <message>
        <source>Inner lines</source>
        <translation>Innere Linien</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>Interior</source>
        <translation>Inneres</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Island at</source>
        <translation>Insel bei</translation>
    </message>
    <message>
        <source>Islands with less volume than this are removed.</source>
        <translation>Inseln mit kleinerem Volumen werden entfernt.</translation>
    </message>
    <message>
        <source>Key colours</source>
        <translation>Farben der Stützpunkte</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Labelled</source>
        <translation>Gelabelt</translation>
    </message>
    <message>
        <source>Labelled parts matter by their weight.</source>
        <translation>Teile mit Label sind nach ihrem Gewicht wichtig.</translation>
    </message>
    <message>
        <source>Labelled regions, each in its own colour.</source>
        <translation>Bereiche mit Label, jeder in eigener Farbe.</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Labels, full path</source>
        <translation>Labels, voller Pfad</translation>
    </message>
    <message>
        <source>Largest cosine between normal and view on a line.</source>
        <translation>Größter Kosinus zwischen Normale und Blickrichtung auf einer Linie.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Lasso&apos;s format</source>
        <translation>Format des Lassos</translation>
    </message>
    <message>
        <source>Lasso&apos;s view</source>
        <translation>Ansicht des Lassos</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Layers without it are not drawn while any layer has it.</source>
        <translation>Ebenen ohne Solo werden nicht gezeichnet, solange eine Ebene es hat.</translation>
    </message>
    <message>
        <source>Layout of headerless data: 256x256x230:uint16:le:0.5,0.5,0.7.</source>
        <translation>Aufbau von Daten ohne Kopf: 256x256x230:uint16:le:0.5,0.5,0.7.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of the strokes on paper.</source>
        <translation>Länge der Striche auf dem Papier.</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>Linsen</translation>
    </message>
    <message>
        <source>Lettering, scale bar and orientation marks.</source>
        <translation>Schrift, Maßstab und Orientierungsmarken.</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Light on what faces the viewer.</source>
        <translation>Licht auf dem, was dem Betrachter zugewandt ist.</translation>
    </message>
    <message>
        <source>Light that reaches every place.</source>
        <translation>Licht, das jede Stelle erreicht.</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Obergrenze</translation>
    </message>
    <message>
        <source>Line opacity by gradient</source>
        <translation>Liniendeckkraft nach Gradient</translation>
    </message>
    <message>
        <source>Line width</source>
        <translation>Linienbreite</translation>
    </message>
    <message>
        <source>Lines along ridges and valleys.</source>
        <translation>Linien entlang von Graten und Tälern.</translation>
    </message>
    <message>
        <source>Lines along silhouettes, ridges and valleys; no dots.</source>
        <translation>Linien entlang von Silhouetten, Graten und Tälern; keine Punkte.</translation>
    </message>
    <message>
        <source>Lines along the silhouettes.</source>
        <translation>Linien entlang der Silhouetten.</translation>
    </message>
    <message>
        <source>Lines behind matter are left out, dashed or thin.</source>
        <translation>Linien hinter Materie werden weggelassen, gestrichelt oder dünn gezeichnet.</translation>
    </message>
    <message>
        <source>Lines where the surface turns away.</source>
        <translation>Linien, wo die Oberfläche sich abwendet.</translation>
    </message>
    <message>
        <source>Lit from the upper left</source>
        <translation>Beleuchtet von links oben</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Low and high corner; what is outside is cut away.</source>
        <translation>Untere und obere Ecke; was außerhalb liegt, wird weggeschnitten.</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Matter</source>
        <translation>Materie</translation>
    </message>
    <message>
        <source>Matter above</source>
        <translation>Materie über</translation>
    </message>
    <message>
        <source>Matter thinner than this never comes forward, so that noise stays hidden.</source>
        <translation>Dünnere Materie kommt nie nach vorn, sodass Rauschen verborgen bleibt.</translation>
    </message>
    <message>
        <source>Matter thinner than twice this does not connect, so that a headrest that touches the skin goes; 0: plain connection.</source>
        <translation>Materie, die dünner als das Doppelte ist, verbindet nicht, sodass eine Kopfstütze verschwindet, die die Haut berührt; 0: einfache Verbindung.</translation>
    </message>
    <message>
        <source>Measured from second derivatives, or from two normals on the ray.</source>
        <translation>Gemessen aus zweiten Ableitungen oder aus zwei Normalen auf dem Strahl.</translation>
    </message>
    <message>
        <source>Modern textbook</source>
        <translation>Modernes Lehrbuch</translation>
    </message>
    <message>
        <source>More dots on boundaries.</source>
        <translation>Mehr Punkte auf Grenzflächen.</translation>
    </message>
    <message>
        <source>More dots on near parts.</source>
        <translation>Mehr Punkte auf nahen Teilen.</translation>
    </message>
    <message>
        <source>More dots on silhouettes.</source>
        <translation>Mehr Punkte auf Silhouetten.</translation>
    </message>
    <message>
        <source>Multiplies the opacity of the whole layer.</source>
        <translation>Multipliziert die Deckkraft der ganzen Ebene.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name for people.</source>
        <translation>Name für Menschen.</translation>
    </message>
    <message>
        <source>Name of each label number.</source>
        <translation>Name jeder Labelnummer.</translation>
    </message>
    <message>
        <source>Name of the layer.</source>
        <translation>Name der Ebene.</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Near parts are dark and far ones fade into the paper.</source>
        <translation>Nahe Teile sind dunkel, ferne verblassen ins Papier.</translation>
    </message>
    <message>
        <source>Near parts darker</source>
        <translation>Nahe Teile dunkler</translation>
    </message>
    <message>
        <source>Near parts get more dots; negative: far parts.</source>
        <translation>Nahe Teile erhalten mehr Punkte; negativ: ferne Teile.</translation>
    </message>
    <message>
        <source>Near things are warm and full, far ones cool and light.</source>
        <translation>Nahes ist warm und satt, Fernes kühl und hell.</translation>
    </message>
    <message>
        <source>Near things are warm, far ones cool; nothing fades.</source>
        <translation>Nahes ist warm, Fernes kühl; nichts verblasst.</translation>
    </message>
    <message>
        <source>Neighbourhood</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Night blue</source>
        <translation>Nachtblau</translation>
    </message>
    <message>
        <source>No paper behind the figure.</source>
        <translation>Kein Papier hinter der Abbildung.</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Noise floor</source>
        <translation>Rauschgrenze</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Number of the label to erase.</source>
        <translation>Nummer des zu löschenden Labels.</translation>
    </message>
    <message>
        <source>Number of the object&apos;s label.</source>
        <translation>Nummer des Labels des Objekts.</translation>
    </message>
    <message>
        <source>Numbers in a row of a mask.</source>
        <translation>Zahlen in einer Zeile einer Maske.</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Of the axis &quot;direction&quot;, in the patient&apos;s coordinates.</source>
        <translation>Der Achse „direction“, in Koordinaten des Patienten.</translation>
    </message>
    <message>
        <source>Of the seam around what is in front.</source>
        <translation>Des Saums um das, was vorn liegt.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>One hard edge between shade and light, as in a poster.</source>
        <translation>Eine harte Kante zwischen Schatten und Licht wie auf einem Plakat.</translation>
    </message>
    <message>
        <source>Only these label numbers show.</source>
        <translation>Nur diese Labelnummern sind zu sehen.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity by gradient</source>
        <translation>Deckkraft nach Gradient</translation>
    </message>
    <message>
        <source>Opacity curve</source>
        <translation>Deckkraftkurve</translation>
    </message>
    <message>
        <source>Opacity inside the shape.</source>
        <translation>Deckkraft innerhalb der Form.</translation>
    </message>
    <message>
        <source>Opacity of the outline.</source>
        <translation>Deckkraft des Umrisses.</translation>
    </message>
    <message>
        <source>Opacity shapes</source>
        <translation>Deckkraftformen</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Outer surfaces clear in the middle, so that inner ones show.</source>
        <translation>Äußere Oberflächen sind in der Mitte klar, sodass innere zu sehen sind.</translation>
    </message>
    <message>
        <source>Outline in a colour of its own.</source>
        <translation>Umriss in eigener Farbe.</translation>
    </message>
    <message>
        <source>Outline in figure coordinates, at least three points.</source>
        <translation>Umriss in Koordinaten der Abbildung, mindestens drei Punkte.</translation>
    </message>
    <message>
        <source>Outline of the lens.</source>
        <translation>Umriss der Linse.</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Outlines matter.</source>
        <translation>Umrisse sind wichtig.</translation>
    </message>
    <message>
        <source>Outlines only</source>
        <translation>Nur Umrisse</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>Parallel rays, or rays from an eye.</source>
        <translation>Parallele Strahlen oder Strahlen aus einem Auge.</translation>
    </message>
    <message>
        <source>Pen and ink (hatching)</source>
        <translation>Feder und Tinte (Schraffur)</translation>
    </message>
    <message>
        <source>Pen, brush and grey washes in black ink.</source>
        <translation>Feder, Pinsel und graue Lavierungen in schwarzer Tinte.</translation>
    </message>
    <message>
        <source>Pencil from hard to soft on smooth paper.</source>
        <translation>Bleistift von hart bis weich auf glattem Papier.</translation>
    </message>
    <message>
        <source>Phong&apos;s light</source>
        <translation>Phong-Licht</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Picture inside the project, or a path.</source>
        <translation>Bild im Projekt oder ein Pfad.</translation>
    </message>
    <message>
        <source>Picture inside the project, or bundled:ID.</source>
        <translation>Bild im Projekt oder bundled:KENNUNG.</translation>
    </message>
    <message>
        <source>Pixels per inch of paper.</source>
        <translation>Pixel je Zoll Papier.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Places where importance acts; none: everywhere.</source>
        <translation>Orte, an denen Wichtigkeit wirkt; keine: überall.</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Plain colour instead of a style.</source>
        <translation>Reine Farbe statt eines Stils.</translation>
    </message>
    <message>
        <source>Plain colour of the cut.</source>
        <translation>Reine Farbe des Schnitts.</translation>
    </message>
    <message>
        <source>Plain stipple</source>
        <translation>Einfache Punktierung</translation>
    </message>
    <message>
        <source>Points (gradient 0 to 1, factor of the opacity).</source>
        <translation>Punkte (Gradient 0 bis 1, Faktor der Deckkraft).</translation>
    </message>
    <message>
        <source>Points (value, opacity) by rising value; two at one value are a step.</source>
        <translation>Punkte (Wert, Deckkraft) nach steigendem Wert; zwei bei einem Wert sind eine Stufe.</translation>
    </message>
    <message>
        <source>Points to the side that is cut away.</source>
        <translation>Zeigt zur Seite, die weggeschnitten wird.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Positions of the shape&apos;s corners on the first axis.</source>
        <translation>Lagen der Ecken der Form auf der ersten Achse.</translation>
    </message>
    <message>
        <source>Positions of the shape&apos;s corners on the second axis.</source>
        <translation>Lagen der Ecken der Form auf der zweiten Achse.</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Messstrecke</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Raw layout</source>
        <translation>Rohdatenaufbau</translation>
    </message>
    <message>
        <source>Rays per pixel: 1, 4 or 16.</source>
        <translation>Strahlen je Pixel: 1, 4 oder 16.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Reads the scan&apos;s values and picks the preset that suits it.</source>
        <translation>Liest die Werte der Aufnahme und wählt die passende Vorlage.</translation>
    </message>
    <message>
        <source>Red-chalk study</source>
        <translation>Rötelstudie</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regionen</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Grate</translation>
    </message>
    <message>
        <source>Rising positions of the grid&apos;s columns.</source>
        <translation>Steigende Lagen der Spalten des Gitters.</translation>
    </message>
    <message>
        <source>Rising positions of the grid&apos;s rows.</source>
        <translation>Steigende Lagen der Zeilen des Gitters.</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>SHA-256 of the stored numbers; tells when the scan has changed.</source>
        <translation>SHA-256 der gespeicherten Zahlen; verrät, wenn die Aufnahme sich geändert hat.</translation>
    </message>
    <message>
        <source>Sanguine and black chalk, heightened with white on cream paper.</source>
        <translation>Rötel und schwarze Kreide, mit Weiß gehöht, auf cremefarbenem Papier.</translation>
    </message>
    <message>
        <source>Saturated lithographs with cool shadows, after the plates of Haeckel&apos;s time.</source>
        <translation>Satte Lithografien mit kühlen Schatten, nach den Tafeln der Zeit Haeckels.</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Scan, full path</source>
        <translation>Aufnahme, voller Pfad</translation>
    </message>
    <message>
        <source>Second axis</source>
        <translation>Zweite Achse</translation>
    </message>
    <message>
        <source>Second scan</source>
        <translation>Zweite Aufnahme</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>See-through</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>Segmentation of the scan.</source>
        <translation>Segmentierung der Aufnahme.</translation>
    </message>
    <message>
        <source>Sepia wash</source>
        <translation>Sepialavierung</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Shade and rim matter more than lit flats.</source>
        <translation>Schatten und Rand sind wichtiger als beleuchtete Flächen.</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Shape in the plane of the two axes.</source>
        <translation>Form in der Ebene der beiden Achsen.</translation>
    </message>
    <message>
        <source>Shapes in the plane of the two axes (2d).</source>
        <translation>Formen in der Ebene der beiden Achsen (2d).</translation>
    </message>
    <message>
        <source>Share of the radius over which a hard edge fades.</source>
        <translation>Anteil des Radius, über den eine harte Kante verläuft.</translation>
    </message>
    <message>
        <source>Shares of ambient and diffuse light.</source>
        <translation>Anteile von Umgebungs- und diffusem Licht.</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>Silhouette curves</source>
        <translation>Silhouettenkurven</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size and resolution of the printed figure.</source>
        <translation>Größe und Auflösung der gedruckten Abbildung.</translation>
    </message>
    <message>
        <source>Size of the scan&apos;s file or files; 0: not known.</source>
        <translation>Größe der Datei oder Dateien der Aufnahme; 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>Size of the screen&apos;s dots.</source>
        <translation>Größe der Rasterpunkte.</translation>
    </message>
    <message>
        <source>Skeleton of a body CT under a hint of skin.</source>
        <translation>Skelett eines Körper-CT unter einem Hauch von Haut.</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Skin over bone</source>
        <translation>Haut über Knochen</translation>
    </message>
    <message>
        <source>Skull</source>
        <translation>Schädel</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Smallest gradient on a line.</source>
        <translation>Kleinster Gradient auf einer Linie.</translation>
    </message>
    <message>
        <source>Smallest gradient that gets dots.</source>
        <translation>Kleinster Gradient, der Punkte erhält.</translation>
    </message>
    <message>
        <source>Smallest island</source>
        <translation>Kleinste Insel</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>Specimen</source>
        <translation>Präparat</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>Steps that remove what is not wanted; the scan itself stays as it is.</source>
        <translation>Schritte, die Unerwünschtes entfernen; die Aufnahme selbst bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Stipples</source>
        <translation>Punktierung</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Strength of the highlight.</source>
        <translation>Stärke des Glanzlichts.</translation>
    </message>
    <message>
        <source>Strength of the tone&apos;s colour; 0 leaves only its brightness.</source>
        <translation>Stärke der Farbe des Tons; 0 lässt nur seine Helligkeit übrig.</translation>
    </message>
    <message>
        <source>Stroke length</source>
        <translation>Strichlänge</translation>
    </message>
    <message>
        <source>Stroke width</source>
        <translation>Strichbreite</translation>
    </message>
    <message>
        <source>Strokes along the form&apos;s curvature.</source>
        <translation>Striche entlang der Krümmung der Form.</translation>
    </message>
    <message>
        <source>Strokes follow the form and cross in the shade; no dots.</source>
        <translation>Striche folgen der Form und kreuzen sich im Schatten; keine Punkte.</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Style ids, a row per position of the second axis.</source>
        <translation>Kennungen der Stile, eine Zeile je Lage der zweiten Achse.</translation>
    </message>
    <message>
        <source>Style of the cut.</source>
        <translation>Stil des Schnitts.</translation>
    </message>
    <message>
        <source>Styles</source>
        <translation>Stile</translation>
    </message>
    <message>
        <source>Styles by one measure of the data, or by two.</source>
        <translation>Stile nach einem Maß der Daten oder nach zweien.</translation>
    </message>
    <message>
        <source>Styles or colours along the axis, by rising value (1d), or a grid of styles (2d).</source>
        <translation>Stile oder Farben entlang der Achse, nach steigendem Wert (1d), oder ein Gitter von Stilen (2d).</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Zielpunkt</translation>
    </message>
    <message>
        <source>Terms of the artwork.</source>
        <translation>Nutzungsbedingungen des Kunstwerks.</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>The back of a surface is drawn like its front.</source>
        <translation>Die Rückseite einer Oberfläche wird wie ihre Vorderseite gezeichnet.</translation>
    </message>
    <message>
        <source>The bare bones of a head CT, ivory with enamel teeth.</source>
        <translation>Die bloßen Knochen eines Kopf-CT, Elfenbein mit Zähnen aus Schmelz.</translation>
    </message>
    <message>
        <source>The higher, the smaller the highlight.</source>
        <translation>Je höher, desto kleiner das Glanzlicht.</translation>
    </message>
    <message>
        <source>The layer blurs away from the focus.</source>
        <translation>Die Ebene wird abseits des Fokus unscharf.</translation>
    </message>
    <message>
        <source>The layer is safe from changes in the studio.</source>
        <translation>Die Ebene ist im Studio vor Änderungen sicher.</translation>
    </message>
    <message>
        <source>The lower end of the scan fades away.</source>
        <translation>Das untere Ende der Aufnahme verblasst.</translation>
    </message>
    <message>
        <source>The measure that picks style and opacity.</source>
        <translation>Das Maß, das Stil und Deckkraft bestimmt.</translation>
    </message>
    <message>
        <source>The painted mask, row by row from the low end of the second axis.</source>
        <translation>Die gemalte Maske, Zeile für Zeile vom unteren Ende der zweiten Achse an.</translation>
    </message>
    <message>
        <source>The paper.</source>
        <translation>Das Papier.</translation>
    </message>
    <message>
        <source>The pen keeps its width on flat and bent surfaces alike.</source>
        <translation>Die Feder behält auf flachen und gebogenen Oberflächen die gleiche Breite.</translation>
    </message>
    <message>
        <source>The point in the middle of the picture, in patient coordinates (LPS).</source>
        <translation>Der Punkt in der Bildmitte, in Patientenkoordinaten (LPS).</translation>
    </message>
    <message>
        <source>The point in the patient that the leader points to.</source>
        <translation>Der Punkt im Patienten, auf den die Hinweislinie zeigt.</translation>
    </message>
    <message>
        <source>The point that distances are measured from.</source>
        <translation>Der Punkt, von dem aus Abstände gemessen werden.</translation>
    </message>
    <message>
        <source>The same everywhere, or clearing flat regions first.</source>
        <translation>Überall gleich, oder flache Bereiche zuerst klar.</translation>
    </message>
    <message>
        <source>The same for silhouette and highlights.</source>
        <translation>Dasselbe für Silhouette und Glanzlichter.</translation>
    </message>
    <message>
        <source>The scan lies inside the project file.</source>
        <translation>Die Aufnahme liegt in der Projektdatei.</translation>
    </message>
    <message>
        <source>The scan that is drawn.</source>
        <translation>Die Aufnahme, die gezeichnet wird.</translation>
    </message>
    <message>
        <source>The styles that the figure uses.</source>
        <translation>Die Stile, die die Abbildung verwendet.</translation>
    </message>
    <message>
        <source>The surface of a head or body, CT or MR, as a portrait.</source>
        <translation>Die Oberfläche eines Kopfes oder Körpers, CT oder MR, als Porträt.</translation>
    </message>
    <message>
        <source>The tone is the share of inked paper, or the share of the most dots.</source>
        <translation>Der Tonwert ist der Anteil des mit Tinte bedeckten Papiers oder der Anteil an der größten Punktzahl.</translation>
    </message>
    <message>
        <source>The two measures that pick style and opacity.</source>
        <translation>Die beiden Maße, die Stil und Deckkraft bestimmen.</translation>
    </message>
    <message>
        <source>The view in which the outline was drawn.</source>
        <translation>Die Ansicht, in der der Umriss gezeichnet wurde.</translation>
    </message>
    <message>
        <source>The way the viewer looks; any length but zero.</source>
        <translation>Die Blickrichtung des Betrachters; jede Länge außer null.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>Tönung</translation>
    </message>
    <message>
        <source>Tints along the axis.</source>
        <translation>Tönungen entlang der Achse.</translation>
    </message>
    <message>
        <source>Tints along the view or an axis: aerial perspective.</source>
        <translation>Tönungen entlang der Blickrichtung oder einer Achse: Luftperspektive.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Title of the figure.</source>
        <translation>Titel der Abbildung.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tone</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Tone above which strokes cross; 1: never.</source>
        <translation>Tonwert, über dem sich Striche kreuzen; 1: nie.</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>Zahn</translation>
    </message>
    <message>
        <source>Torso bones</source>
        <translation>Rumpfskelett</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>Transparency</source>
        <translation>Transparenz</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>Transparent washes on white paper, the lights left open.</source>
        <translation>Durchsichtige Lasuren auf weißem Papier, die Lichter ausgespart.</translation>
    </message>
    <message>
        <source>Tried when the project moved without its labels.</source>
        <translation>Versucht, wenn das Projekt ohne seine Labels verschoben wurde.</translation>
    </message>
    <message>
        <source>Tried when the project moved without its scan.</source>
        <translation>Versucht, wenn das Projekt ohne seine Aufnahme verschoben wurde.</translation>
    </message>
    <message>
        <source>Turns an ellipse or a box counter-clockwise.</source>
        <translation>Dreht eine Ellipse oder ein Rechteck gegen den Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Two tones</source>
        <translation>Zwei Töne</translation>
    </message>
    <message>
        <source>Two-sided</source>
        <translation>Zweiseitig</translation>
    </message>
    <message>
        <source>Unocclusion</source>
        <translation>Unverdecktheit</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Valleys</source>
        <translation>Täler</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Vertical fade</source>
        <translation>Vertikales Verblassen</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Volume of label numbers, relative to the project.</source>
        <translation>Volumen mit Labelnummern, relativ zum Projekt.</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Warm light and cool shade over the colours.</source>
        <translation>Warmes Licht und kühler Schatten über den Farben.</translation>
    </message>
    <message>
        <source>Warm to cool</source>
        <translation>Warm nach kalt</translation>
    </message>
    <message>
        <source>Watercolour</source>
        <translation>Aquarell</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Weight of the layer in importance composition.</source>
        <translation>Gewicht der Ebene bei der Komposition nach Wichtigkeit.</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>What counts as an outline.</source>
        <translation>Was als Umriss zählt.</translation>
    </message>
    <message>
        <source>What counts as lit.</source>
        <translation>Was als beleuchtet zählt.</translation>
    </message>
    <message>
        <source>What differs from its surroundings matters.</source>
        <translation>Was sich von seiner Umgebung unterscheidet, ist wichtig.</translation>
    </message>
    <message>
        <source>What is above this value counts as matter.</source>
        <translation>Was über diesem Wert liegt, zählt als Materie.</translation>
    </message>
    <message>
        <source>What is cut away from this layer alone.</source>
        <translation>Was allein von dieser Ebene weggeschnitten wird.</translation>
    </message>
    <message>
        <source>What is cut away to see inside.</source>
        <translation>Was weggeschnitten wird, um ins Innere zu sehen.</translation>
    </message>
    <message>
        <source>What is drawn, one after the other at every sample.</source>
        <translation>Was gezeichnet wird, eines nach dem anderen an jedem Abtastpunkt.</translation>
    </message>
    <message>
        <source>What is far fades away.</source>
        <translation>Was fern ist, verblasst.</translation>
    </message>
    <message>
        <source>What is removed before drawing.</source>
        <translation>Was vor dem Zeichnen entfernt wird.</translation>
    </message>
    <message>
        <source>What is up in the picture; not along the direction.</source>
        <translation>Was im Bild oben ist; nicht entlang der Blickrichtung.</translation>
    </message>
    <message>
        <source>What makes a sample important.</source>
        <translation>Was einen Abtastpunkt wichtig macht.</translation>
    </message>
    <message>
        <source>What matters shows through what lies in front.</source>
        <translation>Wichtiges scheint durch das hindurch, was davor liegt.</translation>
    </message>
    <message>
        <source>What nothing hides matters.</source>
        <translation>Was durch nichts verdeckt wird, ist wichtig.</translation>
    </message>
    <message>
        <source>What stands on the figure.</source>
        <translation>Was auf der Abbildung steht.</translation>
    </message>
    <message>
        <source>What the dots take for matter: the data as they are, or what the layers show.</source>
        <translation>Was für die Punkte als Materie gilt: die Daten, wie sie sind, oder was die Ebenen zeigen.</translation>
    </message>
    <message>
        <source>What themes exchange the style by: bone, skin, vessel ...</source>
        <translation>Wonach Themen den Stil austauschen: Knochen, Haut, Gefäß …</translation>
    </message>
    <message>
        <source>What transfer functions call the style.</source>
        <translation>Wie Transferfunktionen den Stil nennen.</translation>
    </message>
    <message>
        <source>Where along the axis, from 0 to 1.</source>
        <translation>Wo auf der Achse, von 0 bis 1.</translation>
    </message>
    <message>
        <source>Where normal · position is larger, matter is cut away.</source>
        <translation>Wo Normale · Lage größer ist, wird Materie weggeschnitten.</translation>
    </message>
    <message>
        <source>Where on the ramp, from shade (0) to light (1).</source>
        <translation>Wo im Verlauf, vom Schatten (0) bis zum Licht (1).</translation>
    </message>
    <message>
        <source>Where the axis &quot;distance&quot; starts.</source>
        <translation>Wo die Achse „distance“ beginnt.</translation>
    </message>
    <message>
        <source>Where the light comes from.</source>
        <translation>Woher das Licht kommt.</translation>
    </message>
    <message>
        <source>Where the shadow&apos;s light comes from.</source>
        <translation>Woher das Licht für den Schatten kommt.</translation>
    </message>
    <message>
        <source>Where the tone&apos;s light comes from.</source>
        <translation>Woher das Licht für den Ton kommt.</translation>
    </message>
    <message>
        <source>Whether the layer is drawn.</source>
        <translation>Ob die Ebene gezeichnet wird.</translation>
    </message>
    <message>
        <source>Which side of the outline is cut away.</source>
        <translation>Welche Seite des Umrisses weggeschnitten wird.</translation>
    </message>
    <message>
        <source>Which styles and opacity the data get.</source>
        <translation>Welche Stile und Deckkraft die Daten erhalten.</translation>
    </message>
    <message>
        <source>Who made the artwork.</source>
        <translation>Wer das Kunstwerk geschaffen hat.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width by</source>
        <translation>Breite nach</translation>
    </message>
    <message>
        <source>Width of the lines on paper.</source>
        <translation>Breite der Linien auf dem Papier.</translation>
    </message>
    <message>
        <source>Width of the pen on paper.</source>
        <translation>Breite der Feder auf dem Papier.</translation>
    </message>
    <message>
        <source>Width of the printed figure.</source>
        <translation>Breite der gedruckten Abbildung.</translation>
    </message>
    <message>
        <source>Width of the soft border as a share of the shape.</source>
        <translation>Breite des weichen Rands als Anteil der Form.</translation>
    </message>
    <message>
        <source>Width of the strokes on paper.</source>
        <translation>Breite der Striche auf dem Papier.</translation>
    </message>
    <message>
        <source>Width over height of the figure in which the outline was drawn.</source>
        <translation>Breite durch Höhe der Abbildung, in der der Umriss gezeichnet wurde.</translation>
    </message>
    <message>
        <source>Width over height, of an ellipse or a box.</source>
        <translation>Breite durch Höhe, bei einer Ellipse oder einem Rechteck.</translation>
    </message>
    <message>
        <source>Windowed CT</source>
        <translation>Gefenstertes CT</translation>
    </message>
    <message>
        <source>Without a point: the label that distances are measured from.</source>
        <translation>Ohne Punkt: das Label, von dem aus Abstände gemessen werden.</translation>
    </message>
    <message>
        <source>Wood engraving on old paper with arteries and veins overprinted in red and blue.</source>
        <translation>Holzstich auf altem Papier, Arterien und Venen in Rot und Blau überdruckt.</translation>
    </message>
    <message>
        <source>Colour of letters and lines; absent: black, or white on dark paper.</source>
        <translation>Farbe der Buchstaben und Linien; ohne: schwarz, oder weiß auf dunklem Papier.</translation>
    </message>
    <message>
        <source>Course of the curve</source>
        <translation>Verlauf der Kurve</translation>
    </message>
    <message>
        <source>Family of the letters, as the system knows it; empty: DejaVu Sans.</source>
        <translation>Familie der Buchstaben, wie das System sie kennt; leer: DejaVu Sans.</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schriftart</translation>
    </message>
    <message>
        <source>How opacity goes from point to point of the curve.</source>
        <translation>Wie die Deckkraft von Punkt zu Punkt der Kurve verläuft.</translation>
    </message>
    <message>
        <source>Layout of labels</source>
        <translation>Anordnung der Beschriftungen</translation>
    </message>
    <message>
        <source>Length in the patient that the scale bar stands for.</source>
        <translation>Länge im Patienten, für die der Maßstab steht.</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Buchstaben</translation>
    </message>
    <message>
        <source>Place in figure coordinates; absent: found automatically.</source>
        <translation>Ort in Koordinaten der Abbildung; ohne: wird automatisch gefunden.</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Size of the letters on paper; absent: what is usual for the kind.</source>
        <translation>Größe der Buchstaben auf dem Papier; ohne: was für die Art üblich ist.</translation>
    </message>
    <message>
        <source>The column that a label stands in while it is laid out automatically.</source>
        <translation>Die Spalte, in der eine Beschriftung steht, solange sie automatisch angeordnet wird.</translation>
    </message>
    <message>
        <source>What it says; &lt;b&gt;, &lt;i&gt;, &lt;sub&gt; and &lt;sup&gt; mark parts of it.</source>
        <translation>Was darauf steht; &lt;b&gt;, &lt;i&gt;, &lt;sub&gt; und &lt;sup&gt; zeichnen Teile davon aus.</translation>
    </message>
    <message>
        <source>Where labels without a place stand: in columns at the sides, on a ring around the middle, or free beside their points.</source>
        <translation>Wo Beschriftungen ohne Platz stehen: in Spalten an den Seiten, auf einem Ring um die Mitte oder frei neben ihren Punkten.</translation>
    </message>
    <message>
        <source>Largest error asked for; step and other settings are chosen to meet it. As a colour difference 3 is a draft, 1.5 fits screens, 0.7 print.</source>
        <translation>Größter verlangter Fehler; Schrittweite und andere Einstellungen werden danach gewählt. Als Farbabstand ist 3 ein Entwurf, 1,5 passt für Bildschirme, 0,7 für Druck.</translation>
    </message>
    <message>
        <source>Measured as</source>
        <translation>Gemessen als</translation>
    </message>
    <message>
        <source>Of a transfer function; 0: as many as its narrowest feature needs.</source>
        <translation>Einer Transferfunktion; 0: so viele, wie ihr schmalstes Merkmal braucht.</translation>
    </message>
    <message>
        <source>Opacity from all values between two samples, not from one at their middle: thin peaks of a transfer function are not missed.</source>
        <translation>Deckkraft aus allen Werten zwischen zwei Proben, nicht aus einem in ihrer Mitte: Schmale Spitzen einer Transferfunktion werden nicht übersehen.</translation>
    </message>
    <message>
        <source>Pre-integration</source>
        <translation>Vorintegration</translation>
    </message>
    <message>
        <source>Table entries</source>
        <translation>Tabelleneinträge</translation>
    </message>
    <message>
        <source>What the tolerance bounds: the colour difference CIEDE2000 that 95 % of the pixels stay below, the largest difference of a pixel&apos;s channel (0 to 1), or the root mean square of these.</source>
        <translation>Was die Toleranz begrenzt: den Farbabstand CIEDE2000, unter dem 95 % der Pixel bleiben, die größte Abweichung eines Kanals eines Pixels (0 bis 1) oder deren quadratisches Mittel.</translation>
    </message>
    <message>
        <source>curvature of contours</source>
        <translation>Krümmung der Konturen</translation>
    </message>
    <message>
        <source>factors of dots</source>
        <translation>Faktoren der Punkte</translation>
    </message>
    <message>
        <source>gradients and normals</source>
        <translation>Gradienten und Normalen</translation>
    </message>
    <message>
        <source>importance of what cannot claim any</source>
        <translation>Wichtigkeit dessen, was keine haben kann</translation>
    </message>
    <message>
        <source>importance where no lens reaches</source>
        <translation>Wichtigkeit, wo keine Linse hinreicht</translation>
    </message>
    <message>
        <source>importance-aware composition</source>
        <translation>Zusammensetzung nach Wichtigkeit</translation>
    </message>
    <message>
        <source>layers that show nothing</source>
        <translation>Ebenen, die nichts zeigen</translation>
    </message>
    <message>
        <source>look-ups of colours</source>
        <translation>Nachschlagen von Farben</translation>
    </message>
    <message>
        <source>mip levels of styles</source>
        <translation>Verkleinerungen der Stile</translation>
    </message>
    <message>
        <source>rays behind what hides all</source>
        <translation>Strahlen hinter dem, was alles verdeckt</translation>
    </message>
    <message>
        <source>samples of empty blocks</source>
        <translation>Proben in leeren Blöcken</translation>
    </message>
    <message>
        <source>wider voxels</source>
        <translation>breitere Voxel</translation>
    </message>
</context>
<context>
    <name>ExtractionWords</name>
    <message>
        <source>How much of the ball was seen in the artwork; the rest is filled in from around it.</source>
        <translation>Wie viel der Kugel im Kunstwerk zu sehen war; der Rest wird von ringsum ergänzt.</translation>
    </message>
    <message>
        <source>Take a form that shows more sides, erase less, or leave fewer letters out.</source>
        <translation>Eine Form nehmen, die mehr Seiten zeigt, weniger wegradieren oder weniger Buchstaben auslassen.</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>How far the form, shaded again with this style, is from the artwork (root mean square of the colours, 0 to 1).</source>
        <translation>Wie weit die mit diesem Stil neu schattierte Form vom Kunstwerk abweicht (quadratischer Mittelwert der Farben, 0 bis 1).</translation>
    </message>
    <message>
        <source>Look at “Difference”: where it is not grey, mark normals and creases, ignore letters, or choose a form of one material.</source>
        <translation>„Unterschied“ ansehen: Wo es nicht grau ist, Normalen und Falten markieren, Buchstaben ignorieren oder eine Form aus einem einzigen Material wählen.</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>The widest gap between directions that were seen; it is filled smoothly, without guessing.</source>
        <translation>Die größte Lücke zwischen gesehenen Richtungen; sie wird glatt gefüllt, ohne zu raten.</translation>
    </message>
    <message>
        <source>Take in the part of the form that faces that way, or make the style symmetric.</source>
        <translation>Den Teil der Form hinzunehmen, der dorthin zeigt, oder den Stil symmetrisch machen.</translation>
    </message>
    <message>
        <source>Largest hole</source>
        <translation>Größte Lücke</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>How much the style would change if the outline were snapped to the picture&apos;s edge.</source>
        <translation>Wie sehr sich der Stil ändern würde, wenn der Umriss an der Kante des Bildes einrastete.</translation>
    </message>
    <message>
        <source>Press “Snap to edge”, or drag the outline&apos;s handles onto the edge.</source>
        <translation>„An Kante einrasten“ drücken oder die Griffe des Umrisses auf die Kante ziehen.</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Platzierung</translation>
    </message>
    <message>
        <source>How much the style would change if the form were deeper by a quarter: no picture tells its depth.</source>
        <translation>Wie sehr sich der Stil ändern würde, wenn die Form um ein Viertel tiefer wäre: Kein Bild verrät ihre Tiefe.</translation>
    </message>
    <message>
        <source>Set “Depth” to what you know of the form, or mark some normals inside it.</source>
        <translation>„Tiefe“ auf das setzen, was über die Form bekannt ist, oder einige Normalen darin markieren.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>fair</source>
        <translation>mäßig</translation>
    </message>
    <message>
        <source>poor</source>
        <translation>schlecht</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>small</source>
        <extracomment>Names inside a sentence: translate to &quot;small&quot; or to &quot;as they are&quot; (nouns keep their capital), in these words.</extracomment>
        <translation>as they are</translation>
    </message>
</context>
<context>
    <name>StudioBackend</name>
    <message>
        <source>Graphics card where there is one</source>
        <translation>Grafikkarte, wo es eine gibt</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Prozessor</translation>
    </message>
    <message>
        <source>OpenGL, %1</source>
        <translation>OpenGL, %1</translation>
    </message>
    <message>
        <source>processor, %1</source>
        <translation>Prozessor, %1</translation>
    </message>
    <message>
        <source>processor, %1 (%2)</source>
        <translation>Prozessor, %1 (%2)</translation>
    </message>
</context>
<context>
    <name>StudioLanguage</name>
    <message>
        <source>As the desktop</source>
        <translation>Wie die Arbeitsumgebung</translation>
    </message>
</context>
<context>
    <name>Tissues</name>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>Muscle</source>
        <translation>Muskel</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>%1: above %2 HU</source>
        <translation>%1: über %2 HU</translation>
    </message>
    <message>
        <source>%1: about %2 HU</source>
        <translation>%1: etwa %2 HU</translation>
    </message>
    <message>
        <source>%1: %2 to %3 HU</source>
        <translation>%1: %2 bis %3 HU</translation>
    </message>
</context>
<context>
    <name>limner::AccuracyChart</name>
    <message>
        <source>Error against run time, chart</source>
        <translation>Fehler gegen Laufzeit, Diagramm</translation>
    </message>
    <message>
        <source>Time of the whole picture, s</source>
        <translation>Zeit für das ganze Bild, s</translation>
    </message>
    <message>
        <source>%1, order %2</source>
        <translation>%1, Ordnung %2</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Wie es ist</translation>
    </message>
    <message>
        <source>%1: %2 in %3</source>
        <translation>%1: %2 in %3</translation>
    </message>
</context>
<context>
    <name>limner::AccuracyPanel</name>
    <message>
        <source>Find settings</source>
        <translation>Einstellungen finden</translation>
    </message>
    <message>
        <source>Find the settings that keep this error in the least time, and set them</source>
        <translation>Die Einstellungen, die diesen Fehler in der kürzesten Zeit einhalten, finden und setzen</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Untersuchen</translation>
    </message>
    <message>
        <source>Measure what every setting costs in error and in time</source>
        <translation>Messen, was jede Einstellung an Fehler und an Zeit kostet</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Bericht sichern …</translation>
    </message>
    <message>
        <source>Write the study as a page with charts, as a table or as JSON</source>
        <translation>Die Untersuchung als Seite mit Diagrammen, als Tabelle oder als JSON schreiben</translation>
    </message>
    <message>
        <source>What the study found</source>
        <translation>Was die Untersuchung ergab</translation>
    </message>
    <message>
        <source>Show error over the picture</source>
        <translation>Fehler über dem Bild zeigen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>How far the picture may be from one without any error of sampling; the settings for it are found when you let go</source>
        <translation>Wie weit das Bild von einem ohne jeden Abtastfehler entfernt sein darf; die Einstellungen dafür werden beim Loslassen gefunden</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>The error that the picture may have; another number is a tolerance of your own</source>
        <translation>Der Fehler, den das Bild haben darf; eine andere Zahl ist eine eigene Toleranz</translation>
    </message>
    <message>
        <source>Colour difference CIEDE2000 that 95 % of the pixels stay below; 1 is just seen</source>
        <translation>Farbabstand CIEDE2000, unter dem 95 % der Pixel bleiben; 1 sieht man gerade noch</translation>
    </message>
    <message>
        <source>Largest difference of a channel of a pixel, as a share of the full range</source>
        <translation>Größte Abweichung eines Kanals eines Pixels, als Anteil des ganzen Bereichs</translation>
    </message>
    <message>
        <source>Root of the mean square of the differences, as a share of the full range</source>
        <translation>Wurzel aus dem mittleren Quadrat der Abweichungen, als Anteil des ganzen Bereichs</translation>
    </message>
    <message>
        <source>Measured as</source>
        <translation>Gemessen als</translation>
    </message>
    <message>
        <source>What the number bounds</source>
        <translation>Was die Zahl begrenzt</translation>
    </message>
    <message>
        <source>Error at most</source>
        <translation>Fehler höchstens</translation>
    </message>
    <message>
        <source>Error against run time</source>
        <translation>Fehler gegen Laufzeit</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Time for the study</source>
        <translation>Zeit für die Untersuchung</translation>
    </message>
    <message>
        <source>Nothing new is measured after so many seconds</source>
        <translation>Nach so vielen Sekunden wird nichts Neues mehr gemessen</translation>
    </message>
    <message>
        <source>Cheapest settings for each tolerance</source>
        <translation>Günstigste Einstellungen für jede Toleranz</translation>
    </message>
    <message>
        <source>Delivered</source>
        <translation>Erreicht</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>The error on places that the search had not seen</source>
        <translation>Der Fehler an Stellen, die die Suche nicht gesehen hatte</translation>
    </message>
    <message>
        <source>Time that the whole picture takes</source>
        <translation>Zeit, die das ganze Bild braucht</translation>
    </message>
    <message>
        <source>Draws the picture with everything at its best and lays over it how far each pixel is off, until the figure or the view changes</source>
        <translation>Zeichnet das Bild mit allem auf bester Stufe und legt darüber, wie weit jedes Pixel daneben liegt, bis sich Figur oder Ansicht ändern</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop this; nothing is left behind</source>
        <translation>Dies anhalten; es bleibt nichts zurück</translation>
    </message>
    <message>
        <source>Finding settings</source>
        <translation>Einstellungen suchen</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Drawing the error</source>
        <translation>Fehler zeichnen</translation>
    </message>
    <message>
        <source>The figure has changed since.</source>
        <translation>Die Figur hat sich seitdem geändert.</translation>
    </message>
    <message>
        <source>It cannot be told which settings keep %1: the finest picture that can be drawn is itself only sure to %2. Ask for a larger error, or soften what is steep in the transfer functions.</source>
        <translation>Welche Einstellungen %1 einhalten, lässt sich nicht sagen: Das feinste Bild, das sich zeichnen lässt, ist selbst nur auf %2 sicher. Einen größeren Fehler verlangen oder mildern, was in den Transferfunktionen steil ist.</translation>
    </message>
    <message>
        <source>Not reached: asked %1, the best settings deliver %2 (%3). The figure keeps the settings it had. %4</source>
        <translation>Nicht erreicht: verlangt %1, die besten Einstellungen erreichen %2 (%3). Die Figur behält ihre Einstellungen. %4</translation>
    </message>
    <message>
        <source>Delivered %1, asked %2: %3. %4</source>
        <translation>Erreicht %1, verlangt %2: %3. %4</translation>
    </message>
    <message>
        <source>Delivered %1, asked %2: %3, as the figure has it already. %4</source>
        <translation>Erreicht %1, verlangt %2: %3, wie es die Figur schon hat. %4</translation>
    </message>
    <message>
        <source>As it is, the picture takes %1 and is off by %2.</source>
        <translation>Wie es ist, braucht das Bild %1 und liegt um %2 daneben.</translation>
    </message>
    <message>
        <source>%1 (not reached)</source>
        <translation>%1 (nicht erreicht)</translation>
    </message>
    <message>
        <source>Settings left out because the time was up: %1.</source>
        <translation>Weggelassene Einstellungen, weil die Zeit um war: %1.</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>The time was up</source>
        <translation>Die Zeit war um</translation>
    </message>
    <message>
        <source>cannot be told</source>
        <translation>nicht zu sagen</translation>
    </message>
    <message>
        <source>The finest picture that can be drawn is itself not sure enough</source>
        <translation>Das feinste Bild, das sich zeichnen lässt, ist selbst nicht sicher genug</translation>
    </message>
    <message>
        <source>Measure savings</source>
        <translation>Ersparnis messen</translation>
    </message>
    <message>
        <source>Draw the picture with and without what it does not need, by turns, for some seconds</source>
        <translation>Das Bild einige Sekunden lang abwechselnd mit und ohne das zeichnen, was es nicht braucht</translation>
    </message>
    <message>
        <source>What leaving out saves</source>
        <translation>Was das Weglassen spart</translation>
    </message>
    <message>
        <source>What the picture does without</source>
        <translation>Worauf das Bild verzichtet</translation>
    </message>
</context>
<context>
    <name>limner::Actions</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>limner::AnnotationForm</name>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Orientation mark</source>
        <translation>Orientierungsmarke</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>Bildunterschrift</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Columns at the sides</source>
        <translation>Spalten an den Seiten</translation>
    </message>
    <message>
        <source>Ring around the figure</source>
        <translation>Ring um die Abbildung</translation>
    </message>
    <message>
        <source>Free, beside their points</source>
        <translation>Frei, neben ihren Punkten</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>Add a label, a scale bar, a title and the like</source>
        <translation>Eine Beschriftung, einen Maßstab, einen Titel und Ähnliches hinzufügen</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen one (Delete)</source>
        <translation>Das Gewählte entfernen (Entf)</translation>
    </message>
    <message>
        <source>Colour of the letters</source>
        <translation>Farbe der Buchstaben</translation>
    </message>
    <message>
        <source>Own &amp;colour</source>
        <translation>Eigene &amp;Farbe</translation>
    </message>
    <message>
        <source>Whichever is nearer</source>
        <translation>Die nähere</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Placed &amp;automatically</source>
        <translation>&amp;Automatisch platziert</translation>
    </message>
    <message>
        <source>La&amp;bels stand</source>
        <translation>&amp;Beschriftungen stehen</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>What is written over the figure; drag it in the picture to place it</source>
        <translation>Was über die Abbildung geschrieben ist; zum Platzieren im Bild ziehen</translation>
    </message>
    <message>
        <source>Layout of labels</source>
        <translation>Anordnung der Beschriftungen</translation>
    </message>
    <message>
        <source>B</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>I</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Italic</source>
        <translation>Kursiv</translation>
    </message>
    <message>
        <source>x₂</source>
        <translation>x₂</translation>
    </message>
    <message>
        <source>Subscript</source>
        <translation>Tiefgestellt</translation>
    </message>
    <message>
        <source>x²</source>
        <translation>x²</translation>
    </message>
    <message>
        <source>Superscript</source>
        <translation>Hochgestellt</translation>
    </message>
    <message>
        <source>Ω</source>
        <translation>Ω</translation>
    </message>
    <message>
        <source>Greek letters and signs</source>
        <translation>Griechische Buchstaben und Zeichen</translation>
    </message>
    <message>
        <source>Capitals</source>
        <translation>Großbuchstaben</translation>
    </message>
    <message>
        <source>Signs</source>
        <translation>Zeichen</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Text</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Üblich</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Rund</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Length in the patient; in a perspective it is true in the plane of the camera&apos;s target</source>
        <translation>Länge im Patienten; in der Perspektive stimmt sie in der Ebene des Zielpunkts der Kamera</translation>
    </message>
    <message>
        <source>Place from the left edge, in percent of the sheet&apos;s width</source>
        <translation>Lage vom linken Rand, in Prozent der Blattbreite</translation>
    </message>
    <message>
        <source>Place from the top, in percent of the sheet&apos;s height</source>
        <translation>Lage von oben, in Prozent der Blatthöhe</translation>
    </message>
    <message>
        <source>Off where you have dragged it; on gives the place back to the layout</source>
        <translation>Aus, wo von Hand platziert; an gibt den Platz an die Anordnung zurück</translation>
    </message>
    <message>
        <source>Off: black, or white on dark paper</source>
        <translation>Aus: schwarz, oder weiß auf dunklem Papier</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>G&amp;röße</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Länge</translation>
    </message>
    <message>
        <source>&amp;Side</source>
        <translation>&amp;Seite</translation>
    </message>
    <message>
        <source>From the le&amp;ft</source>
        <translation>Von lin&amp;ks</translation>
    </message>
    <message>
        <source>From the &amp;top</source>
        <translation>Von &amp;oben</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>%1 schreiben</translation>
    </message>
    <message>
        <source>Size of letters</source>
        <translation>Größe der Buchstaben</translation>
    </message>
    <message>
        <source>Length of scale bar</source>
        <translation>Länge des Maßstabs</translation>
    </message>
    <message>
        <source>Side of label</source>
        <translation>Seite der Beschriftung</translation>
    </message>
    <message>
        <source>Colour of letters</source>
        <translation>Farbe der Buchstaben</translation>
    </message>
    <message>
        <source>Place automatically</source>
        <translation>Automatisch platzieren</translation>
    </message>
    <message>
        <source>Keep place</source>
        <translation>Platz behalten</translation>
    </message>
    <message>
        <source>Move lettering</source>
        <translation>Schrift verschieben</translation>
    </message>
    <message>
        <source>The figure&apos;s title</source>
        <translation>Der Titel der Abbildung</translation>
    </message>
    <message>
        <source>Its length</source>
        <translation>Seine Länge</translation>
    </message>
    <message>
        <source>Heading, or none</source>
        <translation>Überschrift, oder keine</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
</context>
<context>
    <name>limner::AnnotationOverlay</name>
    <message>
        <source>Move lettering</source>
        <translation>Schrift verschieben</translation>
    </message>
    <message>
        <source>Move label&apos;s point</source>
        <translation>Punkt der Beschriftung verschieben</translation>
    </message>
</context>
<context>
    <name>limner::ArtworkCanvas</name>
    <message>
        <source>Artwork</source>
        <translation>Kunstwerk</translation>
    </message>
    <message>
        <source>The scanned artwork. The wheel zooms, the middle button or Space moves it; arrow keys move what is chosen, Delete removes it.</source>
        <translation>Das eingescannte Kunstwerk. Das Mausrad zoomt, die mittlere Taste oder die Leertaste verschiebt es; Pfeiltasten bewegen das Gewählte, Entf entfernt es.</translation>
    </message>
</context>
<context>
    <name>limner::ArtworkToolBar</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Take a style from a round thing: a ball, an eye, a fruit</source>
        <translation>Einen Stil von etwas Rundem übernehmen: einer Kugel, einem Auge, einer Frucht</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>As the circle, for a ball seen at an angle or egg-shaped</source>
        <translation>Wie der Kreis, für eine schräg gesehene oder eiförmige Kugel</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Take a style from any shaded form: drag around it</source>
        <translation>Einen Stil von einer beliebigen schattierten Form übernehmen: ringsum ziehen</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Paint more of the form, or erase some of it</source>
        <translation>Mehr von der Form malen oder etwas davon wegradieren</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Tell how the form faces at a place</source>
        <translation>Angeben, wohin die Form an einer Stelle zeigt</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>Falte</translation>
    </message>
    <message>
        <source>Draw a ridge or a valley of the form</source>
        <translation>Einen Grat oder ein Tal der Form zeichnen</translation>
    </message>
    <message>
        <source>Open edge</source>
        <translation>Offene Kante</translation>
    </message>
    <message>
        <source>Tell where the form goes on behind something or is cut off</source>
        <translation>Angeben, wo die Form hinter etwas weitergeht oder abgeschnitten ist</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorieren</translation>
    </message>
    <message>
        <source>Paint over letters and lines that are not the form&apos;s</source>
        <translation>Buchstaben und Linien übermalen, die nicht zur Form gehören</translation>
    </message>
    <message>
        <source>Picker</source>
        <translation>Pipette</translation>
    </message>
    <message>
        <source>Make a style of two to five colours picked from the artwork</source>
        <translation>Einen Stil aus zwei bis fünf Farben machen, die aus dem Kunstwerk aufgenommen sind</translation>
    </message>
</context>
<context>
    <name>limner::ArtworkToolOptions</name>
    <message>
        <source>From the &amp;centre</source>
        <translation>Von der &amp;Mitte</translation>
    </message>
    <message>
        <source>Draw from the ball&apos;s centre; off: from edge to edge (Alt does the other)</source>
        <translation>Von der Mitte der Kugel aus zeichnen; aus: von Rand zu Rand (Alt kehrt es um)</translation>
    </message>
    <message>
        <source>Snap to edge</source>
        <translation>An Kante einrasten</translation>
    </message>
    <message>
        <source>Lets the outline follow the picture&apos;s edge near it (S)</source>
        <translation>Lässt den Umriss der nahen Kante des Bildes folgen (S)</translation>
    </message>
    <message>
        <source>&amp;Find the edge</source>
        <translation>&amp;Kante finden</translation>
    </message>
    <message>
        <source>Fits a rough outline to the form it means; off: takes it as drawn</source>
        <translation>Passt einen groben Umriss an die gemeinte Form an; aus: nimmt ihn wie gezeichnet</translation>
    </message>
    <message>
        <source>Brush size</source>
        <translation>Pinselgröße</translation>
    </message>
    <message>
        <source>Radius of the brush on the screen ([ and ])</source>
        <translation>Radius des Pinsels auf dem Bildschirm ([ und ])</translation>
    </message>
    <message>
        <source>Find letters</source>
        <translation>Buchstaben finden</translation>
    </message>
    <message>
        <source>Marks printed letters and leader lines; paint to add, Alt to erase</source>
        <translation>Markiert gedruckte Buchstaben und Hinweislinien; malen fügt hinzu, Alt radiert</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Takes all of this painting away</source>
        <translation>Nimmt alles hier Gemalte weg</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen mark (Delete)</source>
        <translation>Entfernt die gewählte Marke (Entf)</translation>
    </message>
    <message>
        <source>Where the light falls</source>
        <translation>Wo das Licht hinfällt</translation>
    </message>
    <message>
        <source>Between light and shadow</source>
        <translation>Zwischen Licht und Schatten</translation>
    </message>
    <message>
        <source>Turned away from the light</source>
        <translation>Vom Licht abgewandt</translation>
    </message>
    <message>
        <source>Along the edge: reflected light, an ink line</source>
        <translation>Entlang der Kante: reflektiertes Licht, eine Tintenlinie</translation>
    </message>
    <message>
        <source>The small bright spot of something shiny</source>
        <translation>Der kleine helle Fleck von etwas Glänzendem</translation>
    </message>
    <message>
        <source>Takes the chosen colour away (Delete)</source>
        <translation>Nimmt die gewählte Farbe weg (Entf)</translation>
    </message>
</context>
<context>
    <name>limner::BrushTool</name>
    <message>
        <source>Erase form</source>
        <translation>Form radieren</translation>
    </message>
    <message>
        <source>Paint form</source>
        <translation>Form malen</translation>
    </message>
    <message>
        <source>Look here again</source>
        <translation>Hier wieder hinsehen</translation>
    </message>
    <message>
        <source>Ignore here</source>
        <translation>Hier ignorieren</translation>
    </message>
    <message>
        <source>Remove form</source>
        <translation>Form entfernen</translation>
    </message>
    <message>
        <source>Look everywhere</source>
        <translation>Überall hinsehen</translation>
    </message>
    <message>
        <source>Paint the form; Alt erases; [ and ] change the brush</source>
        <translation>Die Form malen; Alt radiert; [ und ] ändern den Pinsel</translation>
    </message>
    <message>
        <source>Paint over letters and lines that are not the form&apos;s; Alt erases; [ and ] change the brush</source>
        <translation>Buchstaben und Linien übermalen, die nicht zur Form gehören; Alt radiert; [ und ] ändern den Pinsel</translation>
    </message>
</context>
<context>
    <name>limner::CleanupForm</name>
    <message>
        <source>&amp;Add step</source>
        <translation>Schritt &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Earlier</source>
        <translation>&amp;Früher</translation>
    </message>
    <message>
        <source>La&amp;ter</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Nothing is taken away. Add a step to remove a table, a headrest, crumbs or a label; the scan itself stays as it is.</source>
        <translation>Nichts wird weggenommen. Einen Schritt hinzufügen, um eine Liege, eine Kopfstütze, Krümel oder ein Label zu entfernen; die Aufnahme selbst bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>&amp;Look from there</source>
        <translation>&amp;Von dort ansehen</translation>
    </message>
    <message>
        <source>Clean-up steps</source>
        <translation>Schritte der Bereinigung</translation>
    </message>
    <message>
        <source>The chosen step runs before the one above it</source>
        <translation>Der gewählte Schritt läuft vor dem über ihm</translation>
    </message>
    <message>
        <source>The chosen step runs after the one below it</source>
        <translation>Der gewählte Schritt läuft nach dem unter ihm</translation>
    </message>
    <message>
        <source>Delete the chosen step; what it took away comes back</source>
        <translation>Den gewählten Schritt löschen; was er weggenommen hat, kommt zurück</translation>
    </message>
    <message>
        <source>Add a step after the others</source>
        <translation>Einen Schritt nach den anderen hinzufügen</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>What is inside the outline</source>
        <translation>Was innerhalb des Umrisses liegt</translation>
    </message>
    <message>
        <source>What is outside</source>
        <translation>Was außerhalb des Umrisses liegt</translation>
    </message>
    <message>
        <source>Side that is cut away</source>
        <translation>Seite, die weggeschnitten wird</translation>
    </message>
    <message>
        <source>Turn the figure to the view in which the outline was drawn</source>
        <translation>Die Abbildung in die Ansicht drehen, in der der Umriss gezeichnet wurde</translation>
    </message>
    <message>
        <source>Label to erase</source>
        <translation>Zu löschendes Label</translation>
    </message>
    <message>
        <source>C&amp;ut away</source>
        <translation>&amp;Wegschneiden</translation>
    </message>
    <message>
        <source>La&amp;bel</source>
        <translation>La&amp;bel</translation>
    </message>
    <message>
        <source>Cut the other side</source>
        <translation>Die andere Seite wegschneiden</translation>
    </message>
    <message>
        <source>Look from the lasso&apos;s view</source>
        <translation>Aus der Ansicht des Lassos blicken</translation>
    </message>
    <message>
        <source>Change label to erase</source>
        <translation>Zu löschendes Label ändern</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Delete clean-up step</source>
        <translation>Bereinigungsschritt löschen</translation>
    </message>
    <message>
        <source>Reorder clean-up steps</source>
        <translation>Bereinigungsschritte umordnen</translation>
    </message>
</context>
<context>
    <name>limner::ClipForm</name>
    <message>
        <source>Plane %1: %2 side cut away</source>
        <translation>Schnittebene %1: Seite %2 weggeschnitten</translation>
    </message>
    <message>
        <source>Cut along the view here</source>
        <translation>Hier quer zur Blickrichtung schneiden</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Colour of cuts</source>
        <translation>Farbe der Schnitte</translation>
    </message>
    <message>
        <source>Right to left</source>
        <translation>Rechts nach links</translation>
    </message>
    <message>
        <source>Front to back</source>
        <translation>Vorn nach hinten</translation>
    </message>
    <message>
        <source>Bottom to top</source>
        <translation>Unten nach oben</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Where the box begins</source>
        <translation>Wo der Quader beginnt</translation>
    </message>
    <message>
        <source>Where the box ends</source>
        <translation>Wo der Quader endet</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Add clip box</source>
        <translation>Ausschnittquader hinzufügen</translation>
    </message>
    <message>
        <source>Remove clip box</source>
        <translation>Ausschnittquader entfernen</translation>
    </message>
    <message>
        <source>Move side of clip box</source>
        <translation>Seite des Ausschnittquaders verschieben</translation>
    </message>
    <message>
        <source>Add a plane through the middle of the view that faces the viewer: what is nearer goes</source>
        <translation>Eine Schnittebene durch die Mitte der Ansicht hinzufügen, die dem Betrachter zugewandt ist: Was näher liegt, verschwindet</translation>
    </message>
    <message>
        <source>Cut away the other side of the chosen plane</source>
        <translation>Die andere Seite der gewählten Schnittebene wegschneiden</translation>
    </message>
    <message>
        <source>Remove the chosen plane</source>
        <translation>Die gewählte Schnittebene entfernen</translation>
    </message>
    <message>
        <source>Cut along the view</source>
        <translation>Quer zur Blickrichtung schneiden</translation>
    </message>
    <message>
        <source>Flip clip plane</source>
        <translation>Schnittebene umkehren</translation>
    </message>
    <message>
        <source>Remove clip plane</source>
        <translation>Schnittebene entfernen</translation>
    </message>
    <message>
        <source>Move clip plane</source>
        <translation>Schnittebene verschieben</translation>
    </message>
    <message>
        <source>Change colour of cuts</source>
        <translation>Farbe der Schnitte ändern</translation>
    </message>
    <message>
        <source>Change cut faces</source>
        <translation>Schnittflächen ändern</translation>
    </message>
    <message>
        <source>As the data are</source>
        <translation>Wie die Daten</translation>
    </message>
    <message>
        <source>Flat, as the layer</source>
        <translation>Flächig, wie die Ebene</translation>
    </message>
    <message>
        <source>Flat, in a colour</source>
        <translation>Flächig, in einer Farbe</translation>
    </message>
    <message>
        <source>Flat, in “%1”</source>
        <translation>Flächig, in „%1“</translation>
    </message>
</context>
<context>
    <name>limner::ClipOverlay</name>
    <message>
        <source>Crop box: the patient&apos;s right side</source>
        <translation>Ausschnittquader: rechte Seite des Patienten</translation>
    </message>
    <message>
        <source>Crop box: the patient&apos;s left side</source>
        <translation>Ausschnittquader: linke Seite des Patienten</translation>
    </message>
    <message>
        <source>Crop box: front</source>
        <translation>Ausschnittquader: vorn</translation>
    </message>
    <message>
        <source>Crop box: back</source>
        <translation>Ausschnittquader: hinten</translation>
    </message>
    <message>
        <source>Crop box: bottom</source>
        <translation>Ausschnittquader: unten</translation>
    </message>
    <message>
        <source>Crop box: top</source>
        <translation>Ausschnittquader: oben</translation>
    </message>
    <message>
        <source>Clip plane %1</source>
        <translation>Schnittebene %1</translation>
    </message>
    <message>
        <source>%1. Drag it, or use the arrow keys: 1 mm, with Shift 0.1 mm</source>
        <translation>%1. Ziehen oder mit den Pfeiltasten verschieben: 1 mm, mit Umschalt 0,1 mm</translation>
    </message>
    <message>
        <source>Remove cut</source>
        <translation>Schnitt entfernen</translation>
    </message>
    <message>
        <source>Move cut</source>
        <translation>Schnitt verschieben</translation>
    </message>
</context>
<context>
    <name>limner::CommandPalette</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Eingeben, was zu tun ist</translation>
    </message>
    <message>
        <source>Name of a command</source>
        <translation>Name eines Befehls</translation>
    </message>
    <message>
        <source>Commands that match</source>
        <translation>Passende Befehle</translation>
    </message>
</context>
<context>
    <name>limner::CreaseTool</name>
    <message>
        <source>Tilt crease</source>
        <translation>Falte neigen</translation>
    </message>
    <message>
        <source>Move crease</source>
        <translation>Falte verschieben</translation>
    </message>
    <message>
        <source>Change crease</source>
        <translation>Falte ändern</translation>
    </message>
    <message>
        <source>Draw crease</source>
        <translation>Falte zeichnen</translation>
    </message>
    <message>
        <source>Remove crease</source>
        <translation>Falte entfernen</translation>
    </message>
    <message>
        <source>valley %1°</source>
        <translation>Tal %1°</translation>
    </message>
    <message>
        <source>ridge %1°</source>
        <translation>Grat %1°</translation>
    </message>
    <message>
        <source>Outline a form first (Region), then draw its creases here</source>
        <translation>Zuerst eine Form umreißen (Bereich), dann hier ihre Falten zeichnen</translation>
    </message>
    <message>
        <source>Click for the next corner; Enter, a double click or the right button ends; Backspace takes one back</source>
        <translation>Für die nächste Ecke klicken; Eingabe, Doppelklick oder die rechte Taste beendet; die Rücktaste nimmt eine Ecke zurück</translation>
    </message>
    <message>
        <source>Drag the round handle: up for a ridge, down for a valley; drag corners to move them; Delete removes</source>
        <translation>Den runden Griff ziehen: nach oben für einen Grat, nach unten für ein Tal; Ecken ziehen, um sie zu verschieben; Entf entfernt</translation>
    </message>
    <message>
        <source>Click along a ridge or a valley of the form</source>
        <translation>Entlang eines Grats oder Tals der Form klicken</translation>
    </message>
</context>
<context>
    <name>limner::CurveEditor</name>
    <message>
        <source>Curve over the %1</source>
        <translation>Kurve über: %1</translation>
    </message>
    <message>
        <source>Drag a point to move it, double click for a new one; the right button or Delete removes a point</source>
        <translation>Einen Punkt ziehen, um ihn zu verschieben, für einen neuen doppelklicken; die rechte Taste oder Entf entfernt einen Punkt</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>Punkt verschieben</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Punkt entfernen</translation>
    </message>
</context>
<context>
    <name>limner::EllipseTool</name>
    <message>
        <source>Move outline</source>
        <translation>Umriss verschieben</translation>
    </message>
    <message>
        <source>Turn outline</source>
        <translation>Umriss drehen</translation>
    </message>
    <message>
        <source>Resize outline</source>
        <translation>Größe des Umrisses ändern</translation>
    </message>
    <message>
        <source>Draw circle</source>
        <translation>Kreis zeichnen</translation>
    </message>
    <message>
        <source>Draw ellipse</source>
        <translation>Ellipse zeichnen</translation>
    </message>
    <message>
        <source>Change outline</source>
        <translation>Umriss ändern</translation>
    </message>
    <message>
        <source>Take the round thing</source>
        <translation>Rundes übernehmen</translation>
    </message>
    <message>
        <source>Remove outline</source>
        <translation>Umriss entfernen</translation>
    </message>
    <message>
        <source>Click to take this round thing, or drag to draw</source>
        <translation>Klicken, um dieses Runde zu übernehmen, oder ziehen, um zu zeichnen</translation>
    </message>
    <message>
        <source>Drag the handles; arrow keys move, Delete removes; drag elsewhere to draw anew</source>
        <translation>Die Griffe ziehen; Pfeiltasten verschieben, Entf entfernt; anderswo ziehen, um neu zu zeichnen</translation>
    </message>
    <message>
        <source>Drag from a ball&apos;s centre to its edge (Alt: from edge to edge)</source>
        <translation>Von der Mitte einer Kugel zu ihrem Rand ziehen (Alt: von Rand zu Rand)</translation>
    </message>
    <message>
        <source>Drag from edge to edge across a ball (Alt: from its centre)</source>
        <translation>Von Rand zu Rand über eine Kugel ziehen (Alt: von ihrer Mitte aus)</translation>
    </message>
    <message>
        <source>Drag from a ball&apos;s centre (Alt: from corner to corner, Shift: a circle)</source>
        <translation>Von der Mitte einer Kugel aus ziehen (Alt: von Ecke zu Ecke, Umschalt: ein Kreis)</translation>
    </message>
    <message>
        <source>Drag the box around a ball (Alt: from its centre, Shift: a circle)</source>
        <translation>Das Rechteck um eine Kugel ziehen (Alt: von ihrer Mitte aus, Umschalt: ein Kreis)</translation>
    </message>
</context>
<context>
    <name>limner::ErrorOverlay</name>
    <message>
        <source>Error of every pixel</source>
        <translation>Fehler jedes Pixels</translation>
    </message>
    <message>
        <source>Error of the picture</source>
        <translation>Fehler des Bildes</translation>
    </message>
</context>
<context>
    <name>limner::ExportDialog</name>
    <message>
        <source>PNG – screen, slides, journals</source>
        <translation>PNG – Bildschirm, Folien, Zeitschriften</translation>
    </message>
    <message>
        <source>TIFF – print</source>
        <translation>TIFF – Druck</translation>
    </message>
    <message>
        <source>JPEG – small, with losses</source>
        <translation>JPEG – klein, mit Verlusten</translation>
    </message>
    <message>
        <source>WebP – web pages</source>
        <translation>WebP – Webseiten</translation>
    </message>
    <message>
        <source>OpenEXR – compositing, 32-bit float</source>
        <translation>OpenEXR – Compositing, 32-Bit-Gleitkomma</translation>
    </message>
    <message>
        <source>SVG – ink as circles and paths, to go on drawing</source>
        <translation>SVG – Tinte als Kreise und Pfade, zum Weiterzeichnen</translation>
    </message>
    <message>
        <source>PDF – ink as circles and paths, print</source>
        <translation>PDF – Tinte als Kreise und Pfade, Druck</translation>
    </message>
    <message>
        <source>less than a second</source>
        <translation>weniger als eine Sekunde</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>etwa %1 min</translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation>etwa %1 h</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>&amp;Keep proportions</source>
        <translation>Seitenverhältnis bei&amp;behalten</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Transparenter Hintergrund</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Width and height change together</source>
        <translation>Breite und Höhe ändern sich gemeinsam</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Pixels per inch of paper: 300 for halftones, 600 to 1200 for line art, 96 for screens</source>
        <translation>Pixel je Zoll Papier: 300 für Halbtöne, 600 bis 1200 für Strichzeichnungen, 96 für Bildschirme</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>Bits of each colour: 16 where the picture will be graded further</source>
        <translation>Bits je Farbe: 16, wenn das Bild noch nachbearbeitet wird</translation>
    </message>
    <message>
        <source>1 ray per pixel</source>
        <translation>1 Strahl je Pixel</translation>
    </message>
    <message>
        <source>%1 rays per pixel</source>
        <translation>%1 Strahlen je Pixel</translation>
    </message>
    <message>
        <source>More rays make edges smoother and take as many times longer</source>
        <translation>Mehr Strahlen glätten Kanten und brauchen entsprechend mehr Zeit</translation>
    </message>
    <message>
        <source>&amp;Resolution</source>
        <translation>&amp;Auflösung</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Farbtiefe</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Nothing behind the figure instead of its background</source>
        <translation>Nichts hinter der Abbildung statt ihres Hintergrunds</translation>
    </message>
    <message>
        <source>JPEG cannot be transparent</source>
        <translation>JPEG kann nicht transparent sein</translation>
    </message>
    <message>
        <source>&lt;b&gt;Ink as vectors&lt;/b&gt;; shaded layers as a picture of&lt;br&gt;%1 × %2 pixels, at most %3</source>
        <translation>&lt;b&gt;Tinte als Vektoren&lt;/b&gt;; schattierte Ebenen als Bild mit&lt;br&gt;%1 × %2 Pixeln, höchstens %3</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 × %2 pixels&lt;/b&gt;&lt;br&gt;at most %3 before compression</source>
        <translation>&lt;b&gt;%1 × %2 Pixel&lt;/b&gt;&lt;br&gt;höchstens %3 vor der Kompression</translation>
    </message>
    <message>
        <source>; %1 to draw</source>
        <translation>; %1 zum Zeichnen</translation>
    </message>
    <message>
        <source>As in the figure</source>
        <translation>Wie in der Abbildung</translation>
    </message>
    <message>
        <source>Journal, one column (85 mm)</source>
        <translation>Zeitschrift, eine Spalte (85 mm)</translation>
    </message>
    <message>
        <source>Journal, one and a half columns (120 mm)</source>
        <translation>Zeitschrift, anderthalb Spalten (120 mm)</translation>
    </message>
    <message>
        <source>Journal, page width (180 mm)</source>
        <translation>Zeitschrift, Seitenbreite (180 mm)</translation>
    </message>
    <message>
        <source>A4 (210 × 297 mm)</source>
        <translation>A4 (210 × 297 mm)</translation>
    </message>
    <message>
        <source>A3 (297 × 420 mm)</source>
        <translation>A3 (297 × 420 mm)</translation>
    </message>
    <message>
        <source>A2 (420 × 594 mm)</source>
        <translation>A2 (420 × 594 mm)</translation>
    </message>
    <message>
        <source>A1 (594 × 841 mm)</source>
        <translation>A1 (594 × 841 mm)</translation>
    </message>
    <message>
        <source>A0, poster (841 × 1189 mm)</source>
        <translation>A0, Poster (841 × 1189 mm)</translation>
    </message>
    <message>
        <source>Screen (1920 × 1080 pixels)</source>
        <translation>Bildschirm (1920 × 1080 Pixel)</translation>
    </message>
    <message>
        <source>Square (1080 × 1080 pixels)</source>
        <translation>Quadrat (1080 × 1080 Pixel)</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Usual sizes; sheets lie or stand as the figure does</source>
        <translation>Übliche Größen; Bögen liegen oder stehen wie die Abbildung</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Unit of width and height</source>
        <translation>Einheit von Breite und Höhe</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>G&amp;röße</translation>
    </message>
    <message>
        <source>&amp;Width × height</source>
        <translation>Breite × &amp;Höhe</translation>
    </message>
    <message>
        <source>S&amp;moothing</source>
        <translation>&amp;Glättung</translation>
    </message>
    <message>
        <source>Choose the file; it is written while you go on working</source>
        <translation>Die Datei wählen; sie wird geschrieben, während die Arbeit weitergeht</translation>
    </message>
    <message>
        <source>What that takes</source>
        <translation>Was das kostet</translation>
    </message>
    <message>
        <source>&lt;br&gt;%1 of memory beside the scan</source>
        <translation>&lt;br&gt;%1 Speicher neben der Aufnahme</translation>
    </message>
</context>
<context>
    <name>limner::ExportQueue</name>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
</context>
<context>
    <name>limner::ExtractionDialog</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Find letters</source>
        <translation>Buchstaben finden</translation>
    </message>
    <message>
        <source>Letters and leader lines are marked; paint to add, Alt erases.</source>
        <translation>Buchstaben und Hinweislinien sind markiert; malen fügt hinzu, Alt radiert.</translation>
    </message>
    <message>
        <source>There are no letters on this artwork.</source>
        <translation>Auf diesem Kunstwerk sind keine Buchstaben.</translation>
    </message>
    <message>
        <source>Style from artwork</source>
        <translation>Stil aus Kunstwerk</translation>
    </message>
    <message>
        <source>Style from artwork – %1</source>
        <translation>Stil aus Kunstwerk – %1</translation>
    </message>
    <message>
        <source>%1 “%2”</source>
        <translation>%1 „%2“</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Open artwork</source>
        <translation>Kunstwerk öffnen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.psd *.webp *.exr *.bmp);;Everything (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.tif *.tiff *.psd *.webp *.exr *.bmp);;Alles (*)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Eingefügtes Bild</translation>
    </message>
    <message>
        <source>There is no picture on the clipboard; copy one, or open a file.</source>
        <translation>In der Zwischenablage ist kein Bild; eines kopieren oder eine Datei öffnen.</translation>
    </message>
    <message>
        <source>Click a dashed outline to take it, or draw around a form.</source>
        <translation>Auf einen gestrichelten Umriss klicken, um ihn zu übernehmen, oder um eine Form ziehen.</translation>
    </message>
    <message>
        <source>Outline form</source>
        <translation>Form umreißen</translation>
    </message>
    <message>
        <source>Nothing stands out within the outline: it is taken as drawn.</source>
        <translation>Innerhalb des Umrisses hebt sich nichts ab: Er wird wie gezeichnet genommen.</translation>
    </message>
    <message>
        <source>Brush and Shift or Alt with the lasso mend the form; normals and creases tell its shape.</source>
        <translation>Pinsel sowie Umschalt oder Alt mit dem Lasso bessern die Form aus; Normalen und Falten geben ihre Gestalt an.</translation>
    </message>
    <message>
        <source>There is no edge near the outline to follow.</source>
        <translation>In der Nähe des Umrisses ist keine Kante, der er folgen könnte.</translation>
    </message>
    <message>
        <source>Snap to edge</source>
        <translation>An Kante einrasten</translation>
    </message>
    <message>
        <source>The outline follows the edge now.</source>
        <translation>Der Umriss folgt jetzt der Kante.</translation>
    </message>
    <message>
        <source>Click a dashed outline or draw around a form: the style appears here.</source>
        <translation>Auf einen gestrichelten Umriss klicken oder um eine Form ziehen: Hier erscheint der Stil.</translation>
    </message>
    <message>
        <source>Pick light and shadow: the style appears here.</source>
        <translation>Licht und Schatten aufnehmen: Hier erscheint der Stil.</translation>
    </message>
    <message>
        <source>Open an artwork to take styles from.</source>
        <translation>Ein Kunstwerk öffnen, um Stile daraus zu übernehmen.</translation>
    </message>
    <message>
        <source>No style comes of this form; the line above the artwork says why.</source>
        <translation>Aus dieser Form wird kein Stil; die Zeile über dem Kunstwerk sagt, warum.</translation>
    </message>
    <message>
        <source>Open a scan to use styles on it</source>
        <translation>Eine Aufnahme öffnen, um Stile darauf anzuwenden</translation>
    </message>
    <message>
        <source>The chosen layer is locked</source>
        <translation>Die gewählte Ebene ist gesperrt</translation>
    </message>
    <message>
        <source>The figure with the style is shown here.</source>
        <translation>Hier wird die Abbildung mit dem Stil gezeigt.</translation>
    </message>
    <message>
        <source>Style “%1”</source>
        <translation>Stil „%1“</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>“%1” is in your styles and on the figure. Draw the next form, or close.</source>
        <translation>„%1“ ist bei den eigenen Stilen und auf der Abbildung. Die nächste Form zeichnen oder schließen.</translation>
    </message>
    <message>
        <source>“%1” is in your styles. Draw the next form, or close.</source>
        <translation>„%1“ ist bei den eigenen Stilen. Die nächste Form zeichnen oder schließen.</translation>
    </message>
    <message>
        <source>Style not added</source>
        <translation>Stil nicht hinzugefügt</translation>
    </message>
    <message>
        <source>The style on the ball has not been added. Close without it?</source>
        <translation>Der Stil auf der Kugel wurde nicht hinzugefügt. Ohne ihn schließen?</translation>
    </message>
    <message>
        <source>Dropped picture</source>
        <translation>Abgelegtes Bild</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Repeat what was taken back</source>
        <translation>Das Zurückgenommene wiederholen</translation>
    </message>
    <message>
        <source>Open artwork…</source>
        <translation>Kunstwerk öffnen …</translation>
    </message>
    <message>
        <source>Open a scanned artwork; it can be dropped here, too</source>
        <translation>Ein eingescanntes Kunstwerk öffnen; es kann auch hier abgelegt werden</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Take the picture on the clipboard as the artwork</source>
        <translation>Das Bild aus der Zwischenablage als Kunstwerk nehmen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole artwork</source>
        <translation>Das ganze Kunstwerk zeigen</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>Show one pixel of the artwork as one of the screen</source>
        <translation>Ein Pixel des Kunstwerks als eines des Bildschirms zeigen</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>&lt;b&gt;Take styles from an artwork&lt;/b&gt;&lt;br&gt;Open a scanned plate or a painting, drop the file here, or paste a picture.</source>
        <translation>&lt;b&gt;Stile aus einem Kunstwerk übernehmen&lt;/b&gt;&lt;br&gt;Eine eingescannte Tafel oder Malerei öffnen, die Datei hier ablegen oder ein Bild einfügen.</translation>
    </message>
    <message>
        <source>On the figure</source>
        <translation>Auf der Abbildung</translation>
    </message>
</context>
<context>
    <name>limner::ExtractionForm</name>
    <message>
        <source>Show what is filled in</source>
        <translation>Ergänztes zeigen</translation>
    </message>
    <message>
        <source>Tints the parts of the ball that were not seen in the artwork</source>
        <translation>Tönt die Teile der Kugel, die im Kunstwerk nicht zu sehen waren</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>How deep the form is: 1 as deep as it is wide, less for a relief</source>
        <translation>Wie tief die Form ist: 1 so tief wie breit, weniger für ein Relief</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Evens out grain and hatching, edges of light and shadow stay</source>
        <translation>Gleicht Korn und Schraffur aus, Kanten von Licht und Schatten bleiben</translation>
    </message>
    <message>
        <source>Turn light</source>
        <translation>Licht drehen</translation>
    </message>
    <message>
        <source>Turns the light counter-clockwise about the line of sight</source>
        <translation>Dreht das Licht gegen den Uhrzeigersinn um die Blickachse</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Opacity by &amp;angle</source>
        <translation>Deckkraft nach &amp;Winkel</translation>
    </message>
    <message>
        <source>Makes the style clearer where it faces the viewer, or at its rim</source>
        <translation>Macht den Stil klarer, wo er dem Betrachter zugewandt ist, oder am Rand</translation>
    </message>
    <message>
        <source>facing → rim</source>
        <translation>zugewandt → Rand</translation>
    </message>
    <message>
        <source>S&amp;ymmetric about the light</source>
        <translation>S&amp;ymmetrisch zum Licht</translation>
    </message>
    <message>
        <source>Takes the mean of the ball and its mirror image: what is not lighting goes</source>
        <translation>Nimmt das Mittel der Kugel und ihres Spiegelbilds: Was nicht Beleuchtung ist, verschwindet</translation>
    </message>
    <message>
        <source>Remove paper &amp;cast</source>
        <translation>&amp;Papierstich entfernen</translation>
    </message>
    <message>
        <source>As if painted on white paper instead of this one</source>
        <translation>Als wäre auf weißem statt auf diesem Papier gemalt</translation>
    </message>
    <message>
        <source>&amp;Leave letters out</source>
        <translation>&amp;Buchstaben auslassen</translation>
    </message>
    <message>
        <source>Printed letters and leader lines over the form are not looked at</source>
        <translation>Gedruckte Buchstaben und Hinweislinien über der Form werden nicht beachtet</translation>
    </message>
    <message>
        <source>Separate te&amp;xture</source>
        <translation>Te&amp;xtur abtrennen</translation>
    </message>
    <message>
        <source>Keeps grain, hatching and patterns as a tile beside the lighting</source>
        <translation>Hält Korn, Schraffur und Muster als Kachel neben der Beleuchtung</translation>
    </message>
    <message>
        <source>Texture tile</source>
        <translation>Texturkachel</translation>
    </message>
    <message>
        <source>What the lighting does not explain, as a tile without seams</source>
        <translation>Was die Beleuchtung nicht erklärt, als nahtlose Kachel</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Side of the style&apos;s picture; 512 is plenty for print</source>
        <translation>Seitenlänge des Stilbilds; 512 ist für den Druck reichlich</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>The style as a ball</source>
        <translation>Der Stil als Kugel</translation>
    </message>
    <message>
        <source>Re-shaded</source>
        <translation>Neu schattiert</translation>
    </message>
    <message>
        <source>The form, shaded again with the style: it should look like the artwork</source>
        <translation>Die Form, mit dem Stil neu schattiert: Sie sollte wie das Kunstwerk aussehen</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Grey: as in the artwork; lighter or darker: the artwork is</source>
        <translation>Grau: wie im Kunstwerk; heller oder dunkler: Das Kunstwerk ist es</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Tiefe</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Glättung</translation>
    </message>
    <message>
        <source>T&amp;urn light</source>
        <translation>&amp;Licht drehen</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>G&amp;röße</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>Opacity by angle</source>
        <translation>Deckkraft nach Winkel</translation>
    </message>
    <message>
        <source>Coverage, residual and holes are told here once a style is extracted.</source>
        <translation>Abdeckung, Restfehler und Lücken stehen hier, sobald ein Stil extrahiert ist.</translation>
    </message>
    <message>
        <source>Made of picked colours: there is nothing to measure it by.</source>
        <translation>Aus aufgenommenen Farben gemacht: Es gibt nichts, woran er zu messen wäre.</translation>
    </message>
</context>
<context>
    <name>limner::ExtractionView</name>
    <message>
        <source>Extracted style</source>
        <translation>Extrahierter Stil</translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys, to turn the light</source>
        <translation>Ziehen oder Pfeiltasten drücken, um das Licht zu drehen</translation>
    </message>
    <message>
        <source>Picked colours have no region to compare with.</source>
        <translation>Zu aufgenommenen Farben gibt es keinen Bereich zum Vergleichen.</translation>
    </message>
</context>
<context>
    <name>limner::ExtractionWork</name>
    <message>
        <source>Opening artwork</source>
        <translation>Kunstwerk wird geöffnet</translation>
    </message>
    <message>
        <source>Looking for round things</source>
        <translation>Rundes wird gesucht</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Wird ausgeschnitten</translation>
    </message>
    <message>
        <source>Fitting the outline</source>
        <translation>Umriss wird angepasst</translation>
    </message>
    <message>
        <source>Looking for letters</source>
        <translation>Buchstaben werden gesucht</translation>
    </message>
    <message>
        <source>Extracting</source>
        <translation>Stil wird extrahiert</translation>
    </message>
    <message>
        <source>Adding the style</source>
        <translation>Stil wird hinzugefügt</translation>
    </message>
</context>
<context>
    <name>limner::FigurePreview</name>
    <message>
        <source>The figure in this style</source>
        <translation>Die Abbildung in diesem Stil</translation>
    </message>
</context>
<context>
    <name>limner::GalleryList</name>
    <message>
        <source>Mine</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>This project</source>
        <translation>Dieses Projekt</translation>
    </message>
    <message>
        <source>Bundled</source>
        <translation>Mitgeliefert</translation>
    </message>
    <message>
        <source>Click to use it, or drag it onto the transfer function or the picture</source>
        <translation>Klicken, um ihn zu verwenden, oder auf die Transferfunktion oder das Bild ziehen</translation>
    </message>
    <message>
        <source>Styles</source>
        <translation>Stile</translation>
    </message>
    <message>
        <source>Enter puts the style onto the layer, Control D makes it a favourite, F2 renames it, Delete removes one of your own.</source>
        <translation>Eingabe legt den Stil auf die Ebene, Strg+D macht ihn zum Favoriten, F2 benennt ihn um, Entf löscht einen eigenen.</translation>
    </message>
    <message>
        <source>No styles of your own yet. Take one from an artwork, or import a picture.</source>
        <translation>Noch keine eigenen Stile. Einen aus einem Kunstwerk übernehmen oder ein Bild importieren.</translation>
    </message>
    <message>
        <source>%1, a favourite, %2</source>
        <translation>%1, Favorit, %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Show these styles</source>
        <translation>Diese Stile zeigen</translation>
    </message>
    <message>
        <source>Fold these styles away</source>
        <translation>Diese Stile einklappen</translation>
    </message>
    <message>
        <source>%1, folded</source>
        <translation>%1, eingeklappt</translation>
    </message>
    <message>
        <source>%1, heading</source>
        <translation>%1, Überschrift</translation>
    </message>
</context>
<context>
    <name>limner::HistoryList</name>
    <message>
        <source>Name this state…</source>
        <translation>Diesen Stand benennen …</translation>
    </message>
    <message>
        <source>Keep the figure as it is now under a name, until the program ends</source>
        <translation>Die jetzige Abbildung unter einem Namen behalten, bis das Programm endet</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Take the chosen name away; the figure stays as it is</source>
        <translation>Den gewählten Namen wegnehmen; die Abbildung bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Click on a step to go there, forth and back; no step is lost until something is changed</source>
        <translation>Auf einen Schritt klicken, um vor oder zurück dorthin zu gehen; kein Schritt geht verloren, bis etwas geändert wird</translation>
    </message>
    <message>
        <source>Named states</source>
        <translation>Benannte Stände</translation>
    </message>
    <message>
        <source>Click on a name to go there, as a change that can be undone; F2 renames it</source>
        <translation>Auf einen Namen klicken, um dorthin zu gehen, als Änderung, die sich rückgängig machen lässt; F2 benennt ihn um</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>the current state</source>
        <translation>der jetzige Stand</translation>
    </message>
</context>
<context>
    <name>limner::ImportanceForm</name>
    <message>
        <source>Let what matters &amp;show through</source>
        <translation>Wichtiges hindurch&amp;scheinen lassen</translation>
    </message>
    <message>
        <source>Important matter is seen through what lies in front of it, without cutting anything away</source>
        <translation>Wichtige Materie ist durch das zu sehen, was vor ihr liegt, ohne dass etwas weggeschnitten wird</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>What matters</source>
        <translation>Was wichtig ist</translation>
    </message>
    <message>
        <source>Where it matters</source>
        <translation>Wo es wichtig ist</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Show what matters</source>
        <translation>Wichtiges zeigen</translation>
    </message>
    <message>
        <source>Show nothing through</source>
        <translation>Nichts hindurchscheinen lassen</translation>
    </message>
</context>
<context>
    <name>limner::IslandOverlay</name>
    <message>
        <source>Keep the island here</source>
        <translation>Die Insel hier behalten</translation>
    </message>
    <message>
        <source>There is too little to see here to keep · click on the part that stays · Esc: leave</source>
        <translation>Hier ist zu wenig zu sehen, um es zu behalten · auf den Teil klicken, der bleibt · Esc: verlassen</translation>
    </message>
    <message>
        <source>Click on the part that stays; what is not connected with it goes · Esc: leave</source>
        <translation>Auf den Teil klicken, der bleibt; was nicht mit ihm verbunden ist, verschwindet · Esc: verlassen</translation>
    </message>
</context>
<context>
    <name>limner::LabelList</name>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Show every label that is listed</source>
        <translation>Alle aufgelisteten Labels zeigen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Hide every label that is listed</source>
        <translation>Alle aufgelisteten Labels verbergen</translation>
    </message>
    <message>
        <source>Search labels</source>
        <translation>Labels suchen</translation>
    </message>
    <message>
        <source>Part of a label&apos;s name, or its number</source>
        <translation>Teil eines Labelnamens oder seine Nummer</translation>
    </message>
    <message>
        <source>Labels of the layer</source>
        <translation>Labels der Ebene</translation>
    </message>
    <message>
        <source>The check mark shows or hides a label in the selected layer</source>
        <translation>Das Häkchen zeigt oder verbirgt ein Label in der gewählten Ebene</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Labels</translation>
    </message>
    <message>
        <source>Counting labels</source>
        <translation>Labels werden gezählt</translation>
    </message>
    <message>
        <source>Label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>%1
Label %2, %3 voxels</source>
        <translation>%1
Label %2, %3 Voxel</translation>
    </message>
    <message>
        <source>Show label “%1”</source>
        <translation>Label „%1“ zeigen</translation>
    </message>
    <message>
        <source>Hide label “%1”</source>
        <translation>Label „%1“ verbergen</translation>
    </message>
    <message>
        <source>Show labels</source>
        <translation>Labels zeigen</translation>
    </message>
    <message>
        <source>Hide labels</source>
        <translation>Labels verbergen</translation>
    </message>
</context>
<context>
    <name>limner::LabelTool</name>
    <message>
        <source>Add label</source>
        <translation>Beschriftung hinzufügen</translation>
    </message>
    <message>
        <source>There is too little to see here to point at · click on the structure · Esc: leave</source>
        <translation>Hier ist zu wenig zu sehen, um darauf zu zeigen · auf die Struktur klicken · Esc: verlassen</translation>
    </message>
    <message>
        <source>Click on the structure to name, then type · Esc: leave</source>
        <translation>Auf die zu benennende Struktur klicken, dann tippen · Esc: verlassen</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Type the words, then click on the next structure · Esc: leave</source>
        <translation>Die Wörter tippen, dann auf die nächste Struktur klicken · Esc: verlassen</translation>
    </message>
</context>
<context>
    <name>limner::LayerForm</name>
    <message>
        <source>Even &amp;width</source>
        <translation>Gleiche &amp;Breite</translation>
    </message>
    <message>
        <source>Layer opacity</source>
        <translation>Deckkraft der Ebene</translation>
    </message>
    <message>
        <source>Multiplies the opacity of the whole layer, in percent</source>
        <translation>Multipliziert die Deckkraft der ganzen Ebene, in Prozent</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Layer opacity in percent</source>
        <translation>Deckkraft der Ebene in Prozent</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Illustrative</source>
        <translation>Illustrativ</translation>
    </message>
    <message>
        <source>Transparency</source>
        <translation>Transparenz</translation>
    </message>
    <message>
        <source>Illustrative: clear where the surface faces the viewer, opaque where it turns away, as illustrators draw</source>
        <translation>Illustrativ: klar, wo die Oberfläche dem Betrachter zugewandt ist, deckend, wo sie sich abwendet, wie Illustratoren zeichnen</translation>
    </message>
    <message>
        <source>Change transparency</source>
        <translation>Transparenz ändern</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Phong</source>
        <translation>Phong</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flächig</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>How light is drawn: by the styles, by a head light, or not at all</source>
        <translation>Wie Licht gezeichnet wird: durch die Stile, durch ein Kopflicht oder gar nicht</translation>
    </message>
    <message>
        <source>Change shading</source>
        <translation>Schattierung ändern</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>Draws lines where the surface turns away, in the colours of the styles&apos; rims</source>
        <translation>Zieht Linien, wo die Oberfläche sich abwendet, in den Farben der Stilränder</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Contour thickness in millimetres on paper</source>
        <translation>Konturstärke in Millimetern auf dem Papier</translation>
    </message>
    <message>
        <source>Width of the pen on paper</source>
        <translation>Breite der Feder auf dem Papier</translation>
    </message>
    <message>
        <source>The line follows the curvature: it keeps its width on flat and bent surfaces alike, not only on round ones</source>
        <translation>Die Linie folgt der Krümmung: Sie behält ihre Breite auf flachen und gebogenen Oberflächen, nicht nur auf runden</translation>
    </message>
    <message>
        <source>Draw contours</source>
        <translation>Konturen zeichnen</translation>
    </message>
    <message>
        <source>Remove contours</source>
        <translation>Konturen entfernen</translation>
    </message>
    <message>
        <source>Change contour thickness</source>
        <translation>Konturstärke ändern</translation>
    </message>
    <message>
        <source>Change contours</source>
        <translation>Konturen ändern</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>&amp;Deckkraft</translation>
    </message>
    <message>
        <source>Transpa&amp;rency</source>
        <translation>&amp;Transparenz</translation>
    </message>
    <message>
        <source>Sh&amp;ading</source>
        <translation>&amp;Schattierung</translation>
    </message>
    <message>
        <source>&amp;Contours</source>
        <translation>&amp;Konturen</translation>
    </message>
    <message>
        <source>Change layer opacity</source>
        <translation>Deckkraft der Ebene ändern</translation>
    </message>
</context>
<context>
    <name>limner::LayerList</name>
    <message>
        <source>Layer %1</source>
        <translation>Ebene %1</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a layer behind the selected one</source>
        <translation>Eine Ebene hinter der gewählten hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Copy the selected layer</source>
        <translation>Die gewählte Ebene kopieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the selected layer</source>
        <translation>Die gewählte Ebene löschen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Draw the selected layer earlier</source>
        <translation>Die gewählte Ebene früher zeichnen</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Draw the selected layer later</source>
        <translation>Die gewählte Ebene später zeichnen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Give the selected layer another name</source>
        <translation>Der gewählten Ebene einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it to delete it</source>
        <translation>„%1“ ist gesperrt: zum Löschen entsperren</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Ebene zeigen</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Ebene verbergen</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Ebene umbenennen</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>Ebene duplizieren</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>Ebene löschen</translation>
    </message>
    <message>
        <source>Solo layer</source>
        <translation>Ebene solo zeigen</translation>
    </message>
    <message>
        <source>End solo</source>
        <translation>Solo beenden</translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation>Ebene sperren</translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation>Ebene entsperren</translation>
    </message>
</context>
<context>
    <name>limner::LayerPanel</name>
    <message>
        <source>Depth cues, over all layers</source>
        <translation>Tiefenhinweise, über alle Ebenen</translation>
    </message>
</context>
<context>
    <name>limner::LayerRows</name>
    <message>
        <source>S</source>
        <comment>solo</comment>
        <translation>S</translation>
    </message>
    <message>
        <source>Solo: draw only this layer, and others that are solo</source>
        <translation>Solo: nur diese Ebene zeichnen, und andere, die solo sind</translation>
    </message>
    <message>
        <source>Unlock the layer</source>
        <translation>Die Ebene entsperren</translation>
    </message>
    <message>
        <source>Lock: keep the layer from being changed</source>
        <translation>Sperren: die Ebene vor Änderungen schützen</translation>
    </message>
    <message>
        <source>The check mark shows or hides the layer; a double click renames it; drag to reorder</source>
        <translation>Das Häkchen zeigt oder verbirgt die Ebene; Doppelklick benennt sie um; ziehen ordnet um</translation>
    </message>
</context>
<context>
    <name>limner::LensForm</name>
    <message>
        <source>Add &amp;lens</source>
        <translation>&amp;Linse hinzufügen</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Follow the anatomy</source>
        <translation>Der &amp;Anatomie folgen</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>Linsen</translation>
    </message>
    <message>
        <source>Importance acts under the lenses only; without any it acts everywhere</source>
        <translation>Wichtigkeit wirkt nur unter den Linsen; ohne Linsen wirkt sie überall</translation>
    </message>
    <message>
        <source>Add a lens in the middle of the figure</source>
        <translation>Eine Linse in der Mitte der Abbildung hinzufügen</translation>
    </message>
    <message>
        <source>Remove the chosen lens</source>
        <translation>Die gewählte Linse entfernen</translation>
    </message>
    <message>
        <source>The lens stays on the same place of the body as the view turns</source>
        <translation>Die Linse bleibt an derselben Stelle des Körpers, wenn sich die Ansicht dreht</translation>
    </message>
    <message>
        <source>Anchor lens</source>
        <translation>Linse verankern</translation>
    </message>
    <message>
        <source>Let go of lens</source>
        <translation>Linse lösen</translation>
    </message>
    <message>
        <source>Circular, with an edge</source>
        <translation>Kreisförmig, mit Rand</translation>
    </message>
    <message>
        <source>Gaussian, fading out</source>
        <translation>Gauß, auslaufend</translation>
    </message>
    <message>
        <source>Screen door, of dots</source>
        <translation>Raster aus Punkten</translation>
    </message>
    <message>
        <source>Kind of lens</source>
        <translation>Art der Linse</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Shape of the lens</source>
        <translation>Form der Linse</translation>
    </message>
    <message>
        <source>Change kind of lens</source>
        <translation>Art der Linse ändern</translation>
    </message>
    <message>
        <source>Change shape of lens</source>
        <translation>Form der Linse ändern</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>A&amp;rt</translation>
    </message>
    <message>
        <source>S&amp;hape</source>
        <translation>&amp;Form</translation>
    </message>
    <message>
        <source>Change %1 of lens</source>
        <translation>%1 der Linse ändern</translation>
    </message>
    <message>
        <source>Lens %1</source>
        <translation>Linse %1</translation>
    </message>
    <message>
        <source>Add lens</source>
        <translation>Linse hinzufügen</translation>
    </message>
    <message>
        <source>Remove lens</source>
        <translation>Linse entfernen</translation>
    </message>
</context>
<context>
    <name>limner::LensOverlay</name>
    <message>
        <source>Lens</source>
        <translation>Linse</translation>
    </message>
    <message>
        <source>The chosen lens. Arrow keys move it, plus and minus resize it, Delete removes it, Escape leaves it.</source>
        <translation>Die gewählte Linse. Pfeiltasten verschieben sie, Plus und Minus ändern die Größe, Entf entfernt sie, Esc verlässt sie.</translation>
    </message>
    <message>
        <source>Resize lens</source>
        <translation>Größe der Linse ändern</translation>
    </message>
    <message>
        <source>Move lens</source>
        <translation>Linse verschieben</translation>
    </message>
    <message>
        <source>Remove lens</source>
        <translation>Linse entfernen</translation>
    </message>
</context>
<context>
    <name>limner::LightBall</name>
    <message>
        <source>Direction of the light</source>
        <translation>Richtung des Lichts</translation>
    </message>
    <message>
        <source>Drag over the ball to move the light; outside its rim the light comes from behind</source>
        <translation>Über die Kugel ziehen, um das Licht zu verschieben; außerhalb ihres Rands kommt das Licht von hinten</translation>
    </message>
</context>
<context>
    <name>limner::LightForm</name>
    <message>
        <source>With the viewer</source>
        <translation>Mit dem Betrachter</translation>
    </message>
    <message>
        <source>Fixed to the scan</source>
        <translation>Fest an der Aufnahme</translation>
    </message>
</context>
<context>
    <name>limner::MainWindow</name>
    <message>
        <source>Styles</source>
        <translation>Stile</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Wichtigkeit</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Looks</source>
        <translation>&amp;Looks</translation>
    </message>
    <message>
        <source>&amp;Styles</source>
        <translation>&amp;Stile</translation>
    </message>
    <message>
        <source>Back&amp;ground</source>
        <translation>Hinter&amp;grund</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Main tool bar</source>
        <translation>Hauptwerkzeugleiste</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Lay a ready-made look over the figure</source>
        <translation>Einen fertigen Look auf die Abbildung legen</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thema</translation>
    </message>
    <message>
        <source>Exchange all styles and the paper</source>
        <translation>Alle Stile und das Papier austauschen</translation>
    </message>
    <message>
        <source>%1 “%2”</source>
        <translation>%1 „%2“</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Limner Studio</source>
        <translation>Limner Studio</translation>
    </message>
    <message>
        <source>%1[*] – %2</source>
        <translation>%1[*] – %2</translation>
    </message>
    <message>
        <source>Clean-up</source>
        <translation>Bereinigung</translation>
    </message>
    <message>
        <source>Reading styles, presets and themes</source>
        <translation>Stile, Vorlagen und Themen werden gelesen</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Making the sample head</source>
        <translation>Der Beispielkopf wird erzeugt</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Scans and projects (*.limner *.json *.dcm *.nii *.nii.gz *.hdr *.img *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.tif *.tiff *.png *.inv3 *.inv3.gz);;Everything (*)</source>
        <translation>Aufnahmen und Projekte (*.limner *.json *.dcm *.nii *.nii.gz *.hdr *.img *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.tif *.tiff *.png *.inv3 *.inv3.gz);;Alles (*)</translation>
    </message>
    <message>
        <source>Open folder of slices</source>
        <translation>Schichtordner öffnen</translation>
    </message>
    <message>
        <source>Open labels</source>
        <translation>Labels öffnen</translation>
    </message>
    <message>
        <source>Label volumes (*.nii *.nii.gz *.hdr *.img *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.tif *.tiff);;Everything (*)</source>
        <translation>Labelvolumen (*.nii *.nii.gz *.hdr *.img *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.tif *.tiff);;Alles (*)</translation>
    </message>
    <message>
        <source>The preset “Labelled” draws each label in a colour of its own</source>
        <translation>Die Vorlage „Gelabelt“ zeichnet jedes Label in eigener Farbe</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Limner project (*.limner);;Bare figure (*.json)</source>
        <translation>Limner-Projekt (*.limner);;Reine Abbildung (*.json)</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Preset %1</source>
        <translation>Vorlage %1</translation>
    </message>
    <message>
        <source>Theme %1</source>
        <translation>Thema %1</translation>
    </message>
    <message>
        <source>Copied %1 × %2 pixels</source>
        <translation>%1 × %2 Pixel kopiert</translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation>Was zu tun ist: %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1” first?</source>
        <translation>Die Änderungen an „%1“ zuerst speichern?</translation>
    </message>
    <message>
        <source>About Limner</source>
        <translation>Über Limner</translation>
    </message>
    <message>
        <source>&lt;b&gt;Limner %1&lt;/b&gt;&lt;br&gt;From CT and MR scans to print-ready illustrations.</source>
        <translation>&lt;b&gt;Limner %1&lt;/b&gt;&lt;br&gt;Von CT- und MR-Aufnahmen zu druckfertigen Illustrationen.</translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0. A figure shows what is in the scan; it is not a medical device and not for diagnosis.</source>
        <translation>Freie Software unter der Apache-Lizenz 2.0. Eine Abbildung zeigt, was in der Aufnahme ist; sie ist kein Medizinprodukt und nicht zur Diagnose bestimmt.</translation>
    </message>
    <message>
        <source>Small pictures</source>
        <translation>Kleine Bilder</translation>
    </message>
    <message>
        <source>%1 (open elsewhere)</source>
        <translation>%1 (anderswo geöffnet)</translation>
    </message>
    <message>
        <source>Opening a sample figure</source>
        <translation>Beispielabbildung wird geöffnet</translation>
    </message>
</context>
<context>
    <name>limner::MeasureOverlay</name>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>There is too little to see here to measure · click on the figure · Esc: leave</source>
        <translation>Hier ist zu wenig zum Messen zu sehen · auf die Abbildung klicken · Esc: verlassen</translation>
    </message>
    <message>
        <source>Click on the first place · Esc: leave</source>
        <translation>Auf die erste Stelle klicken · Esc: verlassen</translation>
    </message>
    <message>
        <source>Click on the second place · Backspace: take it back · Esc: leave</source>
        <translation>Auf die zweite Stelle klicken · Rücktaste: zurücknehmen · Esc: verlassen</translation>
    </message>
    <message>
        <source>Click on a third place for the angle · Backspace: take it back · Esc: leave</source>
        <translation>Für den Winkel auf eine dritte Stelle klicken · Rücktaste: zurücknehmen · Esc: verlassen</translation>
    </message>
    <message>
        <source>Click to measure anew · Esc: leave</source>
        <translation>Klicken, um neu zu messen · Esc: verlassen</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
</context>
<context>
    <name>limner::MissingBar</name>
    <message>
        <source>Missing file</source>
        <translation>Fehlende Datei</translation>
    </message>
    <message>
        <source>Show where the file is now</source>
        <translation>Zeigen, wo die Datei jetzt ist</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Hide this; the project stays as it is and looks for the file when it is opened again</source>
        <translation>Dies verbergen; das Projekt bleibt, wie es ist, und sucht die Datei beim nächsten Öffnen wieder</translation>
    </message>
    <message>
        <source>Stop searching</source>
        <translation>Suche anhalten</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Erneut suchen</translation>
    </message>
    <message>
        <source>Stop looking for the file</source>
        <translation>Nicht weiter nach der Datei suchen</translation>
    </message>
    <message>
        <source>Look beside the project, above it and in the folders of recent files</source>
        <translation>Neben dem Projekt, darüber und in den Ordnern zuletzt geöffneter Dateien nachsehen</translation>
    </message>
    <message>
        <source>Find file…</source>
        <translation>Datei suchen …</translation>
    </message>
    <message>
        <source>Find folder…</source>
        <translation>Ordner suchen …</translation>
    </message>
    <message>
        <source>Show where the folder of slices is now</source>
        <translation>Zeigen, wo der Ordner mit den Schichten jetzt ist</translation>
    </message>
</context>
<context>
    <name>limner::NormalTool</name>
    <message>
        <source>Mark a normal</source>
        <translation>Eine Normale markieren</translation>
    </message>
    <message>
        <source>Move normal</source>
        <translation>Normale verschieben</translation>
    </message>
    <message>
        <source>Turn normal</source>
        <translation>Normale drehen</translation>
    </message>
    <message>
        <source>Remove normal</source>
        <translation>Normale entfernen</translation>
    </message>
    <message>
        <source>Outline a form first (Region), then tell its normals here</source>
        <translation>Zuerst eine Form umreißen (Bereich), dann hier ihre Normalen angeben</translation>
    </message>
    <message>
        <source>Drag the needle to turn and tilt it; Ctrl+drag or arrow keys move, Delete removes</source>
        <translation>Die Nadel ziehen, um sie zu drehen und zu neigen; Strg+Ziehen oder Pfeiltasten verschieben, Entf entfernt</translation>
    </message>
    <message>
        <source>Press where you know how the form faces, and drag the needle the way it leans</source>
        <translation>Dort drücken, wo bekannt ist, wohin die Form zeigt, und die Nadel in die Richtung ziehen, in die sie sich neigt</translation>
    </message>
</context>
<context>
    <name>limner::NoticeBar</name>
    <message>
        <source>Notices</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Hide this notice</source>
        <translation>Diesen Hinweis verbergen</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Weniger</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
</context>
<context>
    <name>limner::OpenOutlineTool</name>
    <message>
        <source>Open the outline</source>
        <translation>Den Umriss öffnen</translation>
    </message>
    <message>
        <source>Close the outline</source>
        <translation>Den Umriss schließen</translation>
    </message>
    <message>
        <source>Outline a form first (Region), then tell where its outline is no edge</source>
        <translation>Zuerst eine Form umreißen (Bereich), dann angeben, wo ihr Umriss keine Kante ist</translation>
    </message>
    <message>
        <source>Drag along the outline where the form goes on, hidden or cut off; click one and Delete to remove it</source>
        <translation>Entlang des Umrisses ziehen, wo die Form weitergeht, verdeckt oder abgeschnitten; eine Stelle anklicken und Entf drücken, um sie zu entfernen</translation>
    </message>
</context>
<context>
    <name>limner::OutlineTool</name>
    <message>
        <source>Take away from the form</source>
        <translation>Von der Form wegnehmen</translation>
    </message>
    <message>
        <source>Outline form</source>
        <translation>Form umreißen</translation>
    </message>
    <message>
        <source>Remove form</source>
        <translation>Form entfernen</translation>
    </message>
    <message>
        <source>Drag around a new form; Shift adds to this one, Alt takes away from it</source>
        <translation>Um eine neue Form ziehen; Umschalt fügt zu dieser hinzu, Alt nimmt von ihr weg</translation>
    </message>
    <message>
        <source>Drag roughly around a shaded form: its edge will be found</source>
        <translation>Grob um eine schattierte Form ziehen: Ihre Kante wird gefunden</translation>
    </message>
    <message>
        <source>Drag around a shaded form, along its edge</source>
        <translation>Um eine schattierte Form ziehen, entlang ihrer Kante</translation>
    </message>
</context>
<context>
    <name>limner::OutputList</name>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>begins</source>
        <translation>beginnt</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>stopped; “Go on” continues where it was</source>
        <translation>angehalten; „Fortsetzen“ macht dort weiter</translation>
    </message>
    <message>
        <source>No picture has been exported yet. “Export” writes one while you go on working; several wait for each other here.</source>
        <translation>Noch wurde kein Bild exportiert. „Exportieren“ schreibt eines, während die Arbeit weitergeht; mehrere warten hier aufeinander.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop this; what is drawn already is kept for going on</source>
        <translation>Dies anhalten; was schon gezeichnet ist, bleibt zum Fortsetzen erhalten</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Write this picture again, from where it stopped</source>
        <translation>Dieses Bild noch einmal schreiben, ab der Stelle, an der es anhielt</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Open the picture in the program that your desktop has for it</source>
        <translation>Das Bild in dem Programm öffnen, das die Arbeitsumgebung dafür hat</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Open the folder that the picture is in</source>
        <translation>Den Ordner öffnen, in dem das Bild liegt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take this off the list; a finished picture stays where it is</source>
        <translation>Dies von der Liste nehmen; ein fertiges Bild bleibt, wo es ist</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>Fortschritt von %1</translation>
    </message>
</context>
<context>
    <name>limner::ParameterRow</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>%1, number</source>
        <translation>%1, Zahl</translation>
    </message>
</context>
<context>
    <name>limner::PartForm</name>
    <message>
        <source>Change range of silhouette</source>
        <translation>Bereich der Silhouette ändern</translation>
    </message>
    <message>
        <source>Full up to</source>
        <translation>Voll bis</translation>
    </message>
    <message>
        <source>None from</source>
        <translation>Keine ab</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Nothing: even lines</source>
        <translation>Nichts: gleichmäßige Linien</translation>
    </message>
    <message>
        <source>Curvature: thin where flat</source>
        <translation>Krümmung: dünn, wo flach</translation>
    </message>
    <message>
        <source>Depth: thin where far</source>
        <translation>Tiefe: dünn, wo fern</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Weggelassen</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Gestrichelt</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Dünn</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>Move light</source>
        <translation>Licht verschieben</translation>
    </message>
</context>
<context>
    <name>limner::PickerTool</name>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Mid</source>
        <translation>Mittelton</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Highlight</source>
        <translation>Glanzlicht</translation>
    </message>
    <message>
        <source>Pick %1</source>
        <translation>%1 aufnehmen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Click the colour of “%1”; light and shadow are enough, drag on the ball to turn the light</source>
        <translation>Auf die Farbe von „%1“ klicken; Licht und Schatten genügen, auf der Kugel ziehen, um das Licht zu drehen</translation>
    </message>
</context>
<context>
    <name>limner::PictureWords</name>
    <message>
        <source>What the picture is</source>
        <translation>Was das Bild ist</translation>
    </message>
    <message>
        <source>%1 · %2 × %3 · %4 ms · %5 M samples · %6</source>
        <translation>%1 · %2 × %3 · %4 ms · %5 Mio. Abtastpunkte · %6</translation>
    </message>
    <message>
        <source>final</source>
        <translation>endgültig</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>%1 · %2 to know</source>
        <translation>%1 · %2 zu beachten</translation>
    </message>
    <message>
        <source>Backend, pixels, time and samples of the shown picture</source>
        <translation>Backend, Pixel, Zeit und Abtastpunkte des gezeigten Bildes</translation>
    </message>
    <message>
        <source>Press to read it above the picture</source>
        <translation>Drücken, um es über dem Bild zu lesen</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>processor</source>
        <translation>Prozessor</translation>
    </message>
</context>
<context>
    <name>limner::PositionForm</name>
    <message>
        <source>Colour by position “%1”</source>
        <translation>Farbe nach Lage „%1“</translation>
    </message>
    <message>
        <source>View: near to far</source>
        <translation>Ansicht: nah nach fern</translation>
    </message>
    <message>
        <source>Right to left</source>
        <translation>Rechts nach links</translation>
    </message>
    <message>
        <source>Front to back</source>
        <translation>Vorn nach hinten</translation>
    </message>
    <message>
        <source>Bottom to top</source>
        <translation>Unten nach oben</translation>
    </message>
    <message>
        <source>The view&apos;s direction here, kept</source>
        <translation>Die jetzige Blickrichtung, festgehalten</translation>
    </message>
    <message>
        <source>Change axis</source>
        <translation>Achse ändern</translation>
    </message>
</context>
<context>
    <name>limner::PresetMenu</name>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Vorlage</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>limner::ProgressStrip</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop this; nothing is left behind</source>
        <translation>Dies anhalten; nichts bleibt zurück</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>limner::RampCanvas</name>
    <message>
        <source>Colour ramp</source>
        <translation>Farbverlauf</translation>
    </message>
    <message>
        <source>Drag a key to move it, double click it for another colour, double click the ramp for a new key; the right button or Delete removes a key</source>
        <translation>Einen Stützpunkt ziehen, um ihn zu verschieben, auf ihn doppelklicken für eine andere Farbe, auf den Verlauf doppelklicken für einen neuen; die rechte Taste oder Entf entfernt einen</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Stützpunkt verschieben</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>Stützpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Stützpunkt entfernen</translation>
    </message>
</context>
<context>
    <name>limner::RampEditor</name>
    <message>
        <source>Colour of the key</source>
        <translation>Farbe des Stützpunkts</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a key half way to the next one</source>
        <translation>Einen Stützpunkt auf halbem Weg zum nächsten hinzufügen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Let the ramp jump at the selected key instead of running towards it</source>
        <translation>Den Verlauf am gewählten Stützpunkt springen lassen, statt auf ihn zuzulaufen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected key (Delete)</source>
        <translation>Den gewählten Stützpunkt entfernen (Entf)</translation>
    </message>
    <message>
        <source>Colour of the selected key</source>
        <translation>Farbe des gewählten Stützpunkts</translation>
    </message>
    <message>
        <source>Place of the key</source>
        <translation>Ort des Stützpunkts</translation>
    </message>
    <message>
        <source>Where the selected key lies on the ramp, from 0 to 1</source>
        <translation>Wo der gewählte Stützpunkt im Verlauf liegt, von 0 bis 1</translation>
    </message>
    <message>
        <source>Opacity at the key</source>
        <translation>Deckkraft am Stützpunkt</translation>
    </message>
    <message>
        <source>Factor of the layer&apos;s opacity at the selected key, in percent</source>
        <translation>Faktor der Deckkraft der Ebene am gewählten Stützpunkt, in Prozent</translation>
    </message>
    <message>
        <source>Brightness at the key</source>
        <translation>Helligkeit am Stützpunkt</translation>
    </message>
    <message>
        <source>Strongest factor of the layer&apos;s colours at the selected key; above 100 % brightens</source>
        <translation>Stärkster Faktor der Farben der Ebene am gewählten Stützpunkt; über 100 % hellt auf</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Preset  </source>
        <translation>Vorlage  </translation>
    </message>
    <message>
        <source>Take a ready-made ramp</source>
        <translation>Einen fertigen Verlauf nehmen</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Change colour of key</source>
        <translation>Farbe des Stützpunkts ändern</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Stützpunkt verschieben</translation>
    </message>
    <message>
        <source>Change opacity of key</source>
        <translation>Deckkraft des Stützpunkts ändern</translation>
    </message>
    <message>
        <source>Change brightness of key</source>
        <translation>Helligkeit des Stützpunkts ändern</translation>
    </message>
    <message>
        <source>Make step</source>
        <translation>Stufe einfügen</translation>
    </message>
</context>
<context>
    <name>limner::RecoveryBar</name>
    <message>
        <source>Limner ended without saving this. Do you want it back?</source>
        <translation>Limner wurde beendet, ohne dies zu speichern. Soll es zurückgeholt werden?</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Hide this; it is offered again at the next start</source>
        <translation>Dies verbergen; beim nächsten Start wird es wieder angeboten</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;, changed %2&lt;br&gt;%3</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;, geändert %2&lt;br&gt;%3</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>nie gespeichert</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Open it as it was; it counts as changed until you save it</source>
        <translation>Öffnen, wie es war; es gilt als geändert, bis es gespeichert wird</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Delete it for good</source>
        <translation>Endgültig löschen</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>%1 verwerfen</translation>
    </message>
</context>
<context>
    <name>limner::ScissorsOverlay</name>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>I: cut what is outside</source>
        <translation>I: das Äußere wegschneiden</translation>
    </message>
    <message>
        <source>I: cut what is inside</source>
        <translation>I: das Innere wegschneiden</translation>
    </message>
    <message>
        <source>Scissors: draw around what goes, or click corners · %1 · Esc: leave</source>
        <translation>Schere: um das ziehen, was wegfällt, oder Ecken klicken · %1 · Esc: verlassen</translation>
    </message>
    <message>
        <source>Enter or double click: cut · Backspace: one corner back · %1 · Esc: leave</source>
        <translation>Eingabe oder Doppelklick: schneiden · Rücktaste: eine Ecke zurück · %1 · Esc: verlassen</translation>
    </message>
    <message>
        <source>Cut with scissors</source>
        <translation>Mit der Schere schneiden</translation>
    </message>
</context>
<context>
    <name>limner::ShortcutsDialog</name>
    <message>
        <source>&amp;Assign</source>
        <translation>&amp;Zuweisen</translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>All &amp;standard</source>
        <translation>&amp;Alle auf Standard</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the commands</source>
        <translation>Die Befehle durchsuchen</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>New keys of the chosen command</source>
        <translation>Neue Tasten des gewählten Befehls</translation>
    </message>
    <message>
        <source>Press the keys; Assign without any takes the command&apos;s keys away</source>
        <translation>Die Tasten drücken; Zuweisen ohne Tasten nimmt dem Befehl seine Tasten</translation>
    </message>
    <message>
        <source>The keys that the command comes with</source>
        <translation>Die Tasten, mit denen der Befehl ausgeliefert wird</translation>
    </message>
    <message>
        <source>Take &amp;over</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>“%1” has these keys. It loses them when you take them over.</source>
        <translation>Diese Tasten hat „%1“. Der Befehl verliert sie beim Übernehmen.</translation>
    </message>
</context>
<context>
    <name>limner::SliceCanvas</name>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Axial slice</source>
        <translation>Axiale Schicht</translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation>Koronale Schicht</translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation>Sagittale Schicht</translation>
    </message>
    <message>
        <source>Arrow keys move the cross hairs by a voxel, Page Up and Page Down go to the next slices, plus and minus zoom, Home fits.</source>
        <translation>Pfeiltasten bewegen das Fadenkreuz um ein Voxel, Bild auf und Bild ab gehen zu den nächsten Schichten, Plus und Minus zoomen, Pos1 passt ein.</translation>
    </message>
    <message>
        <source>%1: click to go there, wheel for the next slice, Ctrl and wheel to zoom, Shift and drag to measure</source>
        <translation>%1: klicken, um dorthin zu gehen, Mausrad für die nächste Schicht, Strg und Mausrad zum Zoomen, Umschalt und ziehen zum Messen</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>limner::SlicesPanel</name>
    <message>
        <source>&amp;Look here</source>
        <translation>&amp;Hierher blicken</translation>
    </message>
    <message>
        <source>Value and place of the point</source>
        <translation>Wert und Ort des Punkts</translation>
    </message>
    <message>
        <source>The scan&apos;s value at the cross hairs, and their place in patient coordinates (LPS, mm)</source>
        <translation>Der Wert der Aufnahme am Fadenkreuz und dessen Ort in Patientenkoordinaten (LPS, mm)</translation>
    </message>
    <message>
        <source>Put the point into the middle of the figure; views and turns go about it</source>
        <translation>Den Punkt in die Mitte der Abbildung rücken; Ansichten und Drehungen gehen um ihn</translation>
    </message>
    <message>
        <source>Look at point</source>
        <translation>Auf den Punkt blicken</translation>
    </message>
    <message>
        <source>%1 %2 at %3, %4, %5 mm</source>
        <translation>%1 %2 bei %3, %4, %5 mm</translation>
    </message>
</context>
<context>
    <name>limner::SliderRow</name>
    <message>
        <source>%1, number</source>
        <translation>%1, Zahl</translation>
    </message>
</context>
<context>
    <name>limner::StippleForm</name>
    <message>
        <source>The figure has no marks of ink. Switch them on, or take a ready-made look, to draw with dots, lines and strokes.</source>
        <translation>Die Abbildung hat keine Tintenzeichen. Einschalten oder einen fertigen Look nehmen, um mit Punkten, Linien und Strichen zu zeichnen.</translation>
    </message>
</context>
<context>
    <name>limner::StipplePart</name>
    <message>
        <source>Stipple “%1”</source>
        <translation>Punktierung „%1“</translation>
    </message>
    <message>
        <source>Preset  </source>
        <translation>Vorlage  </translation>
    </message>
    <message>
        <source>Take a ready-made look; ink, dot size and how the dots stand to the layers stay</source>
        <translation>Einen fertigen Look nehmen; Tinte, Punktgröße und das Verhältnis der Punkte zu den Ebenen bleiben</translation>
    </message>
    <message>
        <source>Take ink from style</source>
        <translation>Tinte aus dem Stil nehmen</translation>
    </message>
    <message>
        <source>Use one ink</source>
        <translation>Eine einzige Tinte verwenden</translation>
    </message>
    <message>
        <source>What the tone follows</source>
        <translation>Wonach sich der Tonwert richtet</translation>
    </message>
    <message>
        <source>Nothing yet: all surfaces are as dark as dots can make them.</source>
        <translation>Noch nach nichts: Alle Oberflächen sind so dunkel, wie Punkte sie machen können.</translation>
    </message>
    <message>
        <source>Lines and strokes</source>
        <translation>Linien und Striche</translation>
    </message>
    <message>
        <source>Dots and layers</source>
        <translation>Punkte und Ebenen</translation>
    </message>
    <message>
        <source>Dots under the layers</source>
        <translation>Punkte unter den Ebenen</translation>
    </message>
    <message>
        <source>Dots over the layers</source>
        <translation>Punkte über den Ebenen</translation>
    </message>
    <message>
        <source>Dots alone: no layers</source>
        <translation>Punkte allein: keine Ebenen</translation>
    </message>
    <message>
        <source>The data as they are</source>
        <translation>Die Daten, wie sie sind</translation>
    </message>
    <message>
        <source>What the layers show</source>
        <translation>Was die Ebenen zeigen</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Entfernt</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Fine points</source>
        <translation>Feinheiten</translation>
    </message>
    <message>
        <source>Evenly on paper</source>
        <translation>Gleichmäßig auf dem Papier</translation>
    </message>
    <message>
        <source>Evenly on the volume</source>
        <translation>Gleichmäßig auf dem Volumen</translation>
    </message>
    <message>
        <source>Share of inked paper</source>
        <translation>Anteil des Papiers mit Tinte</translation>
    </message>
    <message>
        <source>Share of the most dots</source>
        <translation>Anteil der größten Punktzahl</translation>
    </message>
    <message>
        <source>Regression (Neumann)</source>
        <translation>Regression (Neumann)</translation>
    </message>
    <message>
        <source>Central differences</source>
        <translation>Zentrale Differenzen</translation>
    </message>
    <message>
        <source>Change seed</source>
        <translation>Startzahl ändern</translation>
    </message>
</context>
<context>
    <name>limner::StudioDocument</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
</context>
<context>
    <name>limner::StyleCardForm</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Ivory bone</source>
        <translation>Elfenbeinknochen</translation>
    </message>
    <message>
        <source>What the gallery calls the style</source>
        <translation>Wie die Galerie den Stil nennt</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Schlagwörter</translation>
    </message>
    <message>
        <source>bone, ink, warm</source>
        <translation>Knochen, Tinte, warm</translation>
    </message>
    <message>
        <source>Words between commas, to find it by</source>
        <translation>Wörter zwischen Kommas, um ihn zu finden</translation>
    </message>
    <message>
        <source>Credit</source>
        <translation>Urheber</translation>
    </message>
    <message>
        <source>Who made the artwork</source>
        <translation>Wer das Kunstwerk geschaffen hat</translation>
    </message>
    <message>
        <source>Named in figures that use the style</source>
        <translation>Wird in Abbildungen genannt, die den Stil verwenden</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>Public domain, CC BY 4.0 …</source>
        <translation>Gemeinfrei, CC BY 4.0 …</translation>
    </message>
    <message>
        <source>What the artwork may be used for</source>
        <translation>Wofür das Kunstwerk verwendet werden darf</translation>
    </message>
    <message>
        <source>&amp;Add to my styles</source>
        <translation>Zu den eigenen Stilen &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Add and &amp;use</source>
        <translation>Hinzufügen und &amp;verwenden</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation>&amp;Schlagwörter</translation>
    </message>
    <message>
        <source>C&amp;redit</source>
        <translation>&amp;Urheber</translation>
    </message>
    <message>
        <source>L&amp;icence</source>
        <translation>L&amp;izenz</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>There is no style yet: draw a form on the artwork</source>
        <translation>Noch ist kein Stil da: eine Form auf dem Kunstwerk zeichnen</translation>
    </message>
    <message>
        <source>Give the style a name first</source>
        <translation>Dem Stil zuerst einen Namen geben</translation>
    </message>
    <message>
        <source>Keeps the style with your own; the dialog stays open for the next</source>
        <translation>Behält den Stil bei den eigenen; der Dialog bleibt für den nächsten offen</translation>
    </message>
    <message>
        <source>Keeps the style and puts it on the chosen layer or style point</source>
        <translation>Behält den Stil und legt ihn auf die gewählte Ebene oder den gewählten Stilpunkt</translation>
    </message>
</context>
<context>
    <name>limner::StyleDetails</name>
    <message>
        <source>One of your own</source>
        <translation>Ein eigener</translation>
    </message>
    <message>
        <source>Kept in this project only</source>
        <translation>Nur in diesem Projekt behalten</translation>
    </message>
    <message>
        <source>Comes with Limner; duplicate it to change its card</source>
        <translation>Mit Limner geliefert; duplizieren, um seine Karte zu ändern</translation>
    </message>
    <message>
        <source>On the scan</source>
        <translation>Auf der Aufnahme</translation>
    </message>
    <message>
        <source>Show how the scan would look in the style that is pointed at or chosen, put where a click would put it</source>
        <translation>Zeigen, wie die Aufnahme in dem Stil aussähe, auf den gezeigt wird oder der gewählt ist, dort angewandt, wo ein Klick ihn anwenden würde</translation>
    </message>
    <message>
        <source>Duplicate to mine</source>
        <translation>Zu eigenen duplizieren</translation>
    </message>
    <message>
        <source>Make a copy among your own styles, whose card you can change</source>
        <translation>Eine Kopie unter den eigenen Stilen anlegen, deren Karte sich ändern lässt</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Remove the style from your own (Delete). It can be brought back</source>
        <translation>Den Stil aus den eigenen entfernen (Entf). Er lässt sich zurückholen</translation>
    </message>
    <message>
        <source>The style as a ball</source>
        <translation>Der Stil als Kugel</translation>
    </message>
    <message>
        <source>The scan in this style</source>
        <translation>Die Aufnahme in diesem Stil</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>What the style is called</source>
        <translation>Wie der Stil heißt</translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation>&amp;Schlagwörter</translation>
    </message>
    <message>
        <source>Words to find it by, with commas between them: bone, ink, warm</source>
        <translation>Wörter, um ihn zu finden, mit Kommas dazwischen: Knochen, Tinte, warm</translation>
    </message>
    <message>
        <source>&amp;Credit</source>
        <translation>U&amp;rheber</translation>
    </message>
    <message>
        <source>Who made the artwork that it was taken from; figures name it</source>
        <translation>Wer das Kunstwerk geschaffen hat, aus dem er stammt; Abbildungen nennen ihn</translation>
    </message>
    <message>
        <source>L&amp;icence</source>
        <translation>L&amp;izenz</translation>
    </message>
    <message>
        <source>On what terms it may be used, such as “CC BY 4.0” or “public domain”</source>
        <translation>Zu welchen Bedingungen er verwendet werden darf, etwa „CC BY 4.0“ oder „gemeinfrei“</translation>
    </message>
    <message>
        <source>none given</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Choose a style to see more of it.</source>
        <translation>Einen Stil wählen, um mehr von ihm zu sehen.</translation>
    </message>
    <message>
        <source>The scan with %1</source>
        <translation>Die Aufnahme mit %1</translation>
    </message>
</context>
<context>
    <name>limner::StyleDrop</name>
    <message>
        <source>other labels</source>
        <translation>andere Labels</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 · around %2</source>
        <translation>%1 · um %2</translation>
    </message>
    <message>
        <source>Where a dragged style would go</source>
        <translation>Wohin ein gezogener Stil käme</translation>
    </message>
    <message>
        <source>Nothing here to put a style onto</source>
        <translation>Hier ist nichts, worauf ein Stil passt</translation>
    </message>
    <message>
        <source>%1 is locked</source>
        <translation>%1 ist gesperrt</translation>
    </message>
    <message>
        <source>All of %1 → %2</source>
        <translation>Alles von %1 → %2</translation>
    </message>
    <message>
        <source>%1 → %2   (Shift: the whole layer)</source>
        <translation>%1 → %2   (Umschalt: die ganze Ebene)</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Looking at the picture</source>
        <translation>Das Bild wird angesehen</translation>
    </message>
    <message>
        <source>Finding what is meant</source>
        <translation>Das Gemeinte wird gesucht</translation>
    </message>
    <message>
        <source>Replace style</source>
        <translation>Stil ersetzen</translation>
    </message>
</context>
<context>
    <name>limner::StyleGallery</name>
    <message>
        <source>★</source>
        <translation>★</translation>
    </message>
    <message>
        <source>Show favourites only. A click on a style&apos;s star, or Control D, makes it one</source>
        <translation>Nur Favoriten zeigen. Ein Klick auf den Stern eines Stils oder Strg+D macht ihn dazu</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Schlagwörter</translation>
    </message>
    <message>
        <source>Show only styles that have these tags</source>
        <translation>Nur Stile mit diesen Schlagwörtern zeigen</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Show the chosen style&apos;s card: a larger ball, how the scan looks in it, its name, tags, credit and licence</source>
        <translation>Die Karte des gewählten Stils zeigen: eine größere Kugel, wie die Aufnahme darin aussieht, Name, Schlagwörter, Urheber und Lizenz</translation>
    </message>
    <message>
        <source>Import picture…</source>
        <translation>Bild importieren …</translation>
    </message>
    <message>
        <source>Add a picture of a shaded ball (a lit sphere, a matcap) to your own styles</source>
        <translation>Das Bild einer schattierten Kugel (einer Lichtkugel, einer Matcap) zu den eigenen Stilen hinzufügen</translation>
    </message>
    <message>
        <source>From artwork…</source>
        <translation>Aus Kunstwerk …</translation>
    </message>
    <message>
        <source>Take a style from a scanned drawing or painting</source>
        <translation>Einen Stil aus einer eingescannten Zeichnung oder Malerei übernehmen</translation>
    </message>
    <message>
        <source>Search styles</source>
        <translation>Stile suchen</translation>
    </message>
    <message>
        <source>Words of a style&apos;s name or tags: bone, ink, glass …</source>
        <translation>Wörter aus Namen oder Schlagwörtern eines Stils: Knochen, Tinte, Glas …</translation>
    </message>
    <message>
        <source>Favourites only</source>
        <translation>Nur Favoriten</translation>
    </message>
    <message>
        <source>Small balls</source>
        <translation>Kleine Kugeln</translation>
    </message>
    <message>
        <source>Medium balls</source>
        <translation>Mittlere Kugeln</translation>
    </message>
    <message>
        <source>Large balls</source>
        <translation>Große Kugeln</translation>
    </message>
    <message>
        <source>Open a scan to use styles.</source>
        <translation>Eine Aufnahme öffnen, um Stile zu verwenden.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is locked.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; ist gesperrt.</translation>
    </message>
    <message>
        <source>A click replaces the selected style of &lt;b&gt;%1&lt;/b&gt;.</source>
        <translation>Ein Klick ersetzt den gewählten Stil von &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>A click styles all of &lt;b&gt;%1&lt;/b&gt;.</source>
        <translation>Ein Klick gestaltet alles von &lt;b&gt;%1&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>Replace style</source>
        <translation>Stil ersetzen</translation>
    </message>
    <message>
        <source>Put onto the layer</source>
        <translation>Auf die Ebene legen</translation>
    </message>
    <message>
        <source>No favourite any more</source>
        <translation>Kein Favorit mehr</translation>
    </message>
    <message>
        <source>Make it a favourite</source>
        <translation>Zum Favoriten machen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate to mine</source>
        <translation>Zu eigenen duplizieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>All styles</source>
        <translation>Alle Stile</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Tags: %1</source>
        <translation>Schlagwörter: %1</translation>
    </message>
    <message>
        <source>Only styles with: %1</source>
        <translation>Nur Stile mit: %1</translation>
    </message>
    <message>
        <source>No favourites yet. Click a style&apos;s star to make it one.</source>
        <translation>Noch keine Favoriten. Auf den Stern eines Stils klicken, um ihn dazu zu machen.</translation>
    </message>
    <message>
        <source>No style has these words and tags.</source>
        <translation>Kein Stil hat diese Wörter und Schlagwörter.</translation>
    </message>
    <message>
        <source>Point at a style to see it on the scan.</source>
        <translation>Auf einen Stil zeigen, um ihn auf der Aufnahme zu sehen.</translation>
    </message>
    <message>
        <source>This layer cannot be changed.</source>
        <translation>Diese Ebene lässt sich nicht ändern.</translation>
    </message>
    <message>
        <source>Open a scan first.</source>
        <translation>Zuerst eine Aufnahme öffnen.</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
</context>
<context>
    <name>limner::StyleShelf</name>
    <message>
        <source>Reading your styles</source>
        <translation>Eigene Stile werden gelesen</translation>
    </message>
    <message>
        <source>Drawing styles</source>
        <translation>Stile werden gezeichnet</translation>
    </message>
    <message>
        <source>Keeping favourites</source>
        <translation>Favoriten werden gespeichert</translation>
    </message>
    <message>
        <source>Writing a style&apos;s card</source>
        <translation>Die Karte eines Stils wird geschrieben</translation>
    </message>
    <message>
        <source>Removing a style</source>
        <translation>Ein Stil wird entfernt</translation>
    </message>
    <message>
        <source>Bringing a style back</source>
        <translation>Ein Stil wird zurückgeholt</translation>
    </message>
</context>
<context>
    <name>limner::ThemeMenu</name>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thema</translation>
    </message>
</context>
<context>
    <name>limner::ToneForm</name>
    <message>
        <source>Tone “%1”</source>
        <translation>Ton „%1“</translation>
    </message>
</context>
<context>
    <name>limner::TransferCanvas</name>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>Move opacity point</source>
        <translation>Deckkraftpunkt verschieben</translation>
    </message>
    <message>
        <source>Move opacity line</source>
        <translation>Deckkraftlinie verschieben</translation>
    </message>
    <message>
        <source>Move style</source>
        <translation>Stil verschieben</translation>
    </message>
    <message>
        <source>Add opacity point</source>
        <translation>Deckkraftpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Make a step here</source>
        <translation>Hier eine Stufe einfügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Make opacity step</source>
        <translation>Deckkraftstufe einfügen</translation>
    </message>
    <message>
        <source>Remove opacity point</source>
        <translation>Deckkraftpunkt entfernen</translation>
    </message>
    <message>
        <source>Remove style</source>
        <translation>Stil entfernen</translation>
    </message>
    <message>
        <source>Replace style</source>
        <translation>Stil ersetzen</translation>
    </message>
    <message>
        <source>Add style</source>
        <translation>Stil hinzufügen</translation>
    </message>
    <message>
        <source>%1%2, opacity %3 %</source>
        <translation>%1%2, Deckkraft %3 %</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Reine Farbe</translation>
    </message>
    <message>
        <source>%1 at %2%3</source>
        <translation>%1 bei %2%3</translation>
    </message>
    <message>
        <source>Select a layer to shape its opacity.</source>
        <translation>Eine Ebene wählen, um ihre Deckkraft zu formen.</translation>
    </message>
    <message>
        <source>Nothing shows yet. Double click to add an opacity point.</source>
        <translation>Noch ist nichts zu sehen. Doppelklicken, um einen Deckkraftpunkt hinzuzufügen.</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>Opacity and style over the data value. Control with arrow keys goes from handle to handle, arrow keys move the handle, Insert adds a point, Delete removes; plus, minus and Home zoom.</source>
        <translation>Deckkraft und Stil über dem Datenwert. Strg mit Pfeiltasten geht von Griff zu Griff, Pfeiltasten verschieben den Griff, Einfg fügt einen Punkt hinzu, Entf entfernt; Plus, Minus und Pos1 zoomen.</translation>
    </message>
    <message>
        <source>Fit to the data (Home)</source>
        <translation>An die Daten anpassen (Pos1)</translation>
    </message>
    <message>
        <source>Show all values</source>
        <translation>Alle Werte zeigen</translation>
    </message>
    <message>
        <source>Zoom to</source>
        <translation>Zoomen auf</translation>
    </message>
    <message>
        <source>Change the curve&apos;s course</source>
        <translation>Verlauf der Kurve ändern</translation>
    </message>
    <message>
        <source>Drag points and styles. Double click adds a point, Delete or the right button removes. The wheel zooms, the middle button moves the ruler; a double click on the ruler fits it to the data.</source>
        <translation>Punkte und Stile ziehen. Doppelklick fügt einen Punkt hinzu, Entf oder die rechte Taste entfernt. Das Mausrad zoomt, die mittlere Taste verschiebt das Lineal; Doppelklick auf das Lineal passt es an die Daten an.</translation>
    </message>
    <message>
        <source>This layer&apos;s transfer function has two axes.</source>
        <translation>Die Transferfunktion dieser Ebene hat zwei Achsen.</translation>
    </message>
</context>
<context>
    <name>limner::TransferCanvas2d</name>
    <message>
        <source>Transfer function over two axes</source>
        <translation>Transferfunktion über zwei Achsen</translation>
    </message>
    <message>
        <source>Opacity shapes and a grid of styles over two measures of the data. Control with arrow keys goes from handle to handle, arrow keys move, Insert adds a shape, Control D duplicates, Delete removes; plus, minus and Home zoom.</source>
        <translation>Deckkraftformen und ein Gitter von Stilen über zwei Maßen der Daten. Strg mit Pfeiltasten geht von Griff zu Griff, Pfeiltasten verschieben, Einfg fügt eine Form hinzu, Strg+D dupliziert, Entf entfernt; Plus, Minus und Pos1 zoomen.</translation>
    </message>
    <message>
        <source>Move style</source>
        <translation>Stil verschieben</translation>
    </message>
    <message>
        <source>Move opacity shape</source>
        <translation>Deckkraftform verschieben</translation>
    </message>
    <message>
        <source>Change the shape&apos;s opacity</source>
        <translation>Deckkraft der Form ändern</translation>
    </message>
    <message>
        <source>Change the shape&apos;s softness</source>
        <translation>Weichheit der Form ändern</translation>
    </message>
    <message>
        <source>Add opacity shape</source>
        <translation>Deckkraftform hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate opacity shape</source>
        <translation>Deckkraftform duplizieren</translation>
    </message>
    <message>
        <source>Remove polygon point</source>
        <translation>Polygonpunkt entfernen</translation>
    </message>
    <message>
        <source>Remove opacity shape</source>
        <translation>Deckkraftform entfernen</translation>
    </message>
    <message>
        <source>Add a column of styles</source>
        <translation>Eine Spalte Stile hinzufügen</translation>
    </message>
    <message>
        <source>Add a row of styles</source>
        <translation>Eine Zeile Stile hinzufügen</translation>
    </message>
    <message>
        <source>Remove a column of styles</source>
        <translation>Eine Spalte Stile entfernen</translation>
    </message>
    <message>
        <source>Remove a row of styles</source>
        <translation>Eine Zeile Stile entfernen</translation>
    </message>
    <message>
        <source>Paint opacity</source>
        <translation>Deckkraft malen</translation>
    </message>
    <message>
        <source>Erase opacity</source>
        <translation>Deckkraft radieren</translation>
    </message>
    <message>
        <source>Add polygon point</source>
        <translation>Polygonpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Remove shape</source>
        <translation>Form entfernen</translation>
    </message>
    <message>
        <source>Remove this column</source>
        <translation>Diese Spalte entfernen</translation>
    </message>
    <message>
        <source>Remove this row</source>
        <translation>Diese Zeile entfernen</translation>
    </message>
    <message>
        <source>Fit to the data (Home)</source>
        <translation>An die Daten anpassen (Pos1)</translation>
    </message>
    <message>
        <source>Zoom to</source>
        <translation>Zoomen auf</translation>
    </message>
    <message>
        <source>Replace style</source>
        <translation>Stil ersetzen</translation>
    </message>
    <message>
        <source>Draw shapes with the tools, drag them and their handles. A double click on a polygon adds a point. Balls are the styles: one moves its column and its row. The wheel zooms, the middle button moves the plane.</source>
        <translation>Mit den Werkzeugen Formen zeichnen, sie und ihre Griffe ziehen. Doppelklick auf ein Polygon fügt einen Punkt hinzu. Kugeln sind die Stile: Eine verschiebt ihre Spalte und ihre Zeile. Das Mausrad zoomt, die mittlere Taste verschiebt die Fläche.</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Reine Farbe</translation>
    </message>
    <message>
        <source>%1 at %2, %3</source>
        <translation>%1 bei %2, %3</translation>
    </message>
    <message>
        <source>Handle at %1, %2</source>
        <translation>Griff bei %1, %2</translation>
    </message>
    <message>
        <source>Shape of %1 % opacity, softness %2 %</source>
        <translation>Form mit %1 % Deckkraft, Weichheit %2 %</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
    <message>
        <source>Select a layer to shape its opacity.</source>
        <translation>Eine Ebene wählen, um ihre Deckkraft zu formen.</translation>
    </message>
</context>
<context>
    <name>limner::TransferEditor</name>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>The measure that picks style and opacity</source>
        <translation>Das Maß, das Stil und Deckkraft bestimmt</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>A second measure: the function is drawn over the plane of both</source>
        <translation>Ein zweites Maß: Die Funktion wird über der Fläche beider gezeichnet</translation>
    </message>
    <message>
        <source>no second axis</source>
        <translation>keine zweite Achse</translation>
    </message>
    <message>
        <source>Change the axis</source>
        <translation>Die Achse ändern</translation>
    </message>
    <message>
        <source>Use one axis</source>
        <translation>Eine Achse verwenden</translation>
    </message>
    <message>
        <source>Use two axes</source>
        <translation>Zwei Achsen verwenden</translation>
    </message>
    <message>
        <source>Change the second axis</source>
        <translation>Die zweite Achse ändern</translation>
    </message>
</context>
<context>
    <name>limner::TransferEditor1d</name>
    <message>
        <source>Add point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Add an opacity point after the selected one</source>
        <translation>Einen Deckkraftpunkt nach dem gewählten hinzufügen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Let the opacity jump at the selected point instead of rising towards it</source>
        <translation>Die Deckkraft am gewählten Punkt springen lassen, statt auf ihn zuzusteigen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected point or style (Delete)</source>
        <translation>Den gewählten Punkt oder Stil entfernen (Entf)</translation>
    </message>
    <message>
        <source>Value of the selected handle</source>
        <translation>Wert des gewählten Griffs</translation>
    </message>
    <message>
        <source>Data value of the selected handle, in the volume&apos;s unit</source>
        <translation>Datenwert des gewählten Griffs, in der Einheit des Volumens</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity of the selected point</source>
        <translation>Deckkraft des gewählten Punkts</translation>
    </message>
    <message>
        <source>Opacity of the selected point, in percent for a thickness of one voxel</source>
        <translation>Deckkraft des gewählten Punkts, in Prozent für eine Dicke von einem Voxel</translation>
    </message>
    <message>
        <source>The layer is locked</source>
        <translation>Die Ebene ist gesperrt</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Nothing selected</source>
        <translation>Nichts gewählt</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Logarithm</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Square root</source>
        <translation>Quadratwurzel</translation>
    </message>
    <message>
        <source>Plain counts</source>
        <translation>Reine Anzahl</translation>
    </message>
    <message>
        <source>Histogram&apos;s scale</source>
        <translation>Skala des Histogramms</translation>
    </message>
    <message>
        <source>How the histogram&apos;s heights follow the number of voxels; the figure stays as it is</source>
        <translation>Wie die Höhen des Histogramms der Voxelzahl folgen; die Abbildung bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
</context>
<context>
    <name>limner::TransferEditor2d</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Duplicate the selected shape (Ctrl+D)</source>
        <translation>Die gewählte Form duplizieren (Strg+D)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected shape or polygon point (Delete)</source>
        <translation>Die gewählte Form oder den gewählten Polygonpunkt entfernen (Entf)</translation>
    </message>
    <message>
        <source>Opacity of the shape</source>
        <translation>Deckkraft der Form</translation>
    </message>
    <message>
        <source>Opacity inside the shape, in percent for a thickness of one voxel</source>
        <translation>Deckkraft in der Form, in Prozent für eine Dicke von einem Voxel</translation>
    </message>
    <message>
        <source>Softness of the shape</source>
        <translation>Weichheit der Form</translation>
    </message>
    <message>
        <source>Width of the soft border inside the shape, in percent of half its extent</source>
        <translation>Breite des weichen Rands in der Form, in Prozent ihrer halben Ausdehnung</translation>
    </message>
    <message>
        <source>+ Column</source>
        <translation>+ Spalte</translation>
    </message>
    <message>
        <source>Add a column of styles to the grid; drop styles from the gallery onto the balls</source>
        <translation>Dem Gitter eine Spalte Stile hinzufügen; Stile aus der Galerie auf die Kugeln legen</translation>
    </message>
    <message>
        <source>+ Row</source>
        <translation>+ Zeile</translation>
    </message>
    <message>
        <source>Add a row of styles to the grid; drop styles from the gallery onto the balls</source>
        <translation>Dem Gitter eine Zeile Stile hinzufügen; Stile aus der Galerie auf die Kugeln legen</translation>
    </message>
    <message>
        <source>− Column</source>
        <translation>− Spalte</translation>
    </message>
    <message>
        <source>Remove the selected style&apos;s column</source>
        <translation>Die Spalte des gewählten Stils entfernen</translation>
    </message>
    <message>
        <source>− Row</source>
        <translation>− Zeile</translation>
    </message>
    <message>
        <source>Remove the selected style&apos;s row</source>
        <translation>Die Zeile des gewählten Stils entfernen</translation>
    </message>
    <message>
        <source>Select, move and resize shapes and styles (Esc)</source>
        <translation>Formen und Stile wählen, verschieben und in der Größe ändern (Esc)</translation>
    </message>
    <message>
        <source>Draw a rectangle of opacity</source>
        <translation>Ein Rechteck aus Deckkraft zeichnen</translation>
    </message>
    <message>
        <source>Draw a trapezoid: ramps along the first axis</source>
        <translation>Ein Trapez zeichnen: Rampen entlang der ersten Achse</translation>
    </message>
    <message>
        <source>Draw an ellipse of opacity</source>
        <translation>Eine Ellipse aus Deckkraft zeichnen</translation>
    </message>
    <message>
        <source>Draw a polygon; a double click on it adds a point</source>
        <translation>Ein Polygon zeichnen; Doppelklick darauf fügt einen Punkt hinzu</translation>
    </message>
    <message>
        <source>Paint opacity freely, with a brush</source>
        <translation>Deckkraft frei mit einem Pinsel malen</translation>
    </message>
    <message>
        <source>Erase painted opacity of the selected mask</source>
        <translation>Gemalte Deckkraft der gewählten Maske radieren</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radius des Pinsels</translation>
    </message>
    <message>
        <source>Radius of the brush, in pixels of the plane</source>
        <translation>Radius des Pinsels, in Pixeln der Fläche</translation>
    </message>
    <message>
        <source>Softness of the brush</source>
        <translation>Weichheit des Pinsels</translation>
    </message>
    <message>
        <source>Share of the brush&apos;s radius over which it fades, in percent</source>
        <translation>Anteil des Pinselradius, über den er ausläuft, in Prozent</translation>
    </message>
    <message>
        <source>Place on the first axis</source>
        <translation>Lage auf der ersten Achse</translation>
    </message>
    <message>
        <source>Place of what is selected on the first axis, in its unit</source>
        <translation>Lage des Gewählten auf der ersten Achse, in deren Einheit</translation>
    </message>
    <message>
        <source>Place on the second axis</source>
        <translation>Lage auf der zweiten Achse</translation>
    </message>
    <message>
        <source>Place of what is selected on the second axis, in its unit</source>
        <translation>Lage des Gewählten auf der zweiten Achse, in deren Einheit</translation>
    </message>
    <message>
        <source>First axis</source>
        <translation>Erste Achse</translation>
    </message>
    <message>
        <source>Second axis</source>
        <translation>Zweite Achse</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
</context>
<context>
    <name>limner::TransferPlane</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
    <message>
        <source>%1. A click shows it.</source>
        <translation>%1. Ein Klick zeigt es.</translation>
    </message>
</context>
<context>
    <name>limner::VariantDialog</name>
    <message>
        <source>Variants</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Was sich unterscheidet</translation>
    </message>
    <message>
        <source>Other looks, or a number of the figure at several values</source>
        <translation>Andere Looks oder eine Zahl der Abbildung mit mehreren Werten</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> Bilder</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Wie viele</translation>
    </message>
    <message>
        <source>&amp;Take</source>
        <translation>&amp;Nehmen</translation>
    </message>
    <message>
        <source>Make the chosen variant the figure (double click does it too)</source>
        <translation>Die gewählte Variante zur Abbildung machen (auch per Doppelklick)</translation>
    </message>
    <message>
        <source>Themes</source>
        <translation>Themen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>My looks</source>
        <translation>Eigene Looks</translation>
    </message>
    <message>
        <source>Open a scan first</source>
        <translation>Zuerst eine Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Wird gezeichnet …</translation>
    </message>
    <message>
        <source>A double click takes one; Undo gives it back</source>
        <translation>Ein Doppelklick nimmt eine; Rückgängig stellt den vorigen Stand wieder her</translation>
    </message>
    <message>
        <source>There is nothing of this kind for this figure</source>
        <translation>Für diese Abbildung gibt es nichts dergleichen</translation>
    </message>
    <message>
        <source>Take variant %1</source>
        <translation>Variante %1 nehmen</translation>
    </message>
</context>
<context>
    <name>limner::ViewForm</name>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>The patient&apos;s front</source>
        <translation>Die Vorderseite des Patienten</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>The patient&apos;s back</source>
        <translation>Die Rückseite des Patienten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>The patient&apos;s left side</source>
        <translation>Die linke Seite des Patienten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>The patient&apos;s right side</source>
        <translation>Die rechte Seite des Patienten</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>From above the head</source>
        <translation>Von oberhalb des Kopfes</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>From below the feet</source>
        <translation>Von unterhalb der Füße</translation>
    </message>
    <message>
        <source>3/4</source>
        <translation>3/4</translation>
    </message>
    <message>
        <source>From the front, turned and from a little above</source>
        <translation>Von vorn, gedreht und leicht von oben</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Fill the sheet with what is visible</source>
        <translation>Das Blatt mit dem füllen, was sichtbar ist</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Change projection</source>
        <translation>Projektion ändern</translation>
    </message>
    <message>
        <source>Change perspective</source>
        <translation>Perspektive ändern</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Round the patient, in degrees: 0 before the face, 90 at the patient&apos;s left side</source>
        <translation>Um den Patienten, in Grad: 0 vor dem Gesicht, 90 an der linken Seite des Patienten</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigen</translation>
    </message>
    <message>
        <source>Height of the viewer, in degrees: 90 straight above, −90 straight below</source>
        <translation>Höhe des Betrachters, in Grad: 90 genau oben, −90 genau unten</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Lean of the picture, in degrees, counter-clockwise</source>
        <translation>Neigung des Bildes, in Grad, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn, tilt, roll</source>
        <translation>Drehen, Neigen, Rollen</translation>
    </message>
    <message>
        <source>Middle, towards the patient&apos;s left</source>
        <translation>Mitte, zur linken Seite des Patienten hin</translation>
    </message>
    <message>
        <source>Middle, towards the back</source>
        <translation>Mitte, nach hinten</translation>
    </message>
    <message>
        <source>Middle, towards the head</source>
        <translation>Mitte, zum Kopf hin</translation>
    </message>
    <message>
        <source>%1, in mm</source>
        <translation>%1, in mm</translation>
    </message>
    <message>
        <source>Move middle of view</source>
        <translation>Mitte der Ansicht verschieben</translation>
    </message>
    <message>
        <source>Middle (mm)</source>
        <translation>Mitte (mm)</translation>
    </message>
    <message>
        <source>Turn view</source>
        <translation>Ansicht drehen</translation>
    </message>
</context>
<context>
    <name>limner::Viewport</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The figure. Arrow keys turn it, plus and minus zoom.</source>
        <translation>Die Abbildung. Pfeiltasten drehen sie, Plus und Minus zoomen.</translation>
    </message>
    <message>
        <source>Drag to turn, drag with the middle button or Shift to move, wheel to zoom, double click to fit.</source>
        <translation>Ziehen zum Drehen, mit mittlerer Taste oder Umschalt ziehen zum Verschieben, Mausrad zum Zoomen, Doppelklick zum Einpassen.</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Wird gezeichnet …</translation>
    </message>
    <message>
        <source>Move view</source>
        <translation>Ansicht verschieben</translation>
    </message>
    <message>
        <source>Turn view</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Fit view</source>
        <translation>Ansicht einpassen</translation>
    </message>
    <message>
        <source>Standard view</source>
        <translation>Standardansicht</translation>
    </message>
</context>
<context>
    <name>limner::WelcomePage</name>
    <message>
        <source>Limner</source>
        <translation>Limner</translation>
    </message>
    <message>
        <source>From a CT or MR scan to a print-ready illustration.</source>
        <translation>Von der CT- oder MR-Aufnahme zur druckfertigen Illustration.</translation>
    </message>
    <message>
        <source>Open a scan or project…</source>
        <translation>Aufnahme oder Projekt öffnen …</translation>
    </message>
    <message>
        <source>Open a folder of slices…</source>
        <translation>Schichtordner öffnen …</translation>
    </message>
    <message>
        <source>Try the sample head</source>
        <translation>Beispielkopf ausprobieren</translation>
    </message>
    <message>
        <source>A built-in head with skin, skull and vessels; nothing is downloaded</source>
        <translation>Ein eingebauter Kopf mit Haut, Schädel und Gefäßen; nichts wird heruntergeladen</translation>
    </message>
    <message>
        <source>Or drop it here: a DICOM folder or file, NIfTI, NRRD, MetaImage, VTK, TIFF or PNG stacks, InVesalius, or a .limner project.</source>
        <translation>Oder hier ablegen: einen DICOM-Ordner oder eine Datei, NIfTI, NRRD, MetaImage, VTK, TIFF- oder PNG-Stapel, InVesalius oder ein .limner-Projekt.</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Sample figures</source>
        <translation>Beispielabbildungen</translation>
    </message>
    <message>
        <source>Figures that come with Limner, on the head CT of this machine; Enter or a double click opens</source>
        <translation>Mit Limner gelieferte Abbildungen, auf dem Kopf-CT dieses Rechners; Eingabe oder Doppelklick öffnet</translation>
    </message>
</context>
<context>
    <name>limner::WidenOverlay</name>
    <message>
        <source>Widen range</source>
        <translation>Bereich erweitern</translation>
    </message>
    <message>
        <source>Reading the values under the pointer</source>
        <translation>Die Werte unter dem Zeiger werden gelesen</translation>
    </message>
    <message>
        <source>The layer is locked · choose another one · Esc: leave</source>
        <translation>Die Ebene ist gesperrt · eine andere wählen · Esc: verlassen</translation>
    </message>
    <message>
        <source>This works over the axes value and gradient · choose another layer · Esc: leave</source>
        <translation>Dies geht über den Achsen Wert und Gradient · eine andere Ebene wählen · Esc: verlassen</translation>
    </message>
    <message>
        <source>There was nothing to read there · drag over the structure · Esc: leave</source>
        <translation>Dort war nichts zu lesen · über die Struktur ziehen · Esc: verlassen</translation>
    </message>
    <message>
        <source>Drag over what the chosen layer is to show too · Esc: leave</source>
        <translation>Über das ziehen, was die gewählte Ebene auch zeigen soll · Esc: verlassen</translation>
    </message>
</context>
<context>
    <name>limner::WindowAccuracy</name>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Set accuracy: %1</source>
        <translation>Genauigkeit setzen: %1</translation>
    </message>
    <message>
        <source>Stopped: the figure or the view has changed.</source>
        <translation>Angehalten: Figur oder Ansicht haben sich geändert.</translation>
    </message>
    <message>
        <source>The error is no longer shown: the picture has changed</source>
        <translation>Der Fehler wird nicht mehr gezeigt: Das Bild hat sich geändert</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Bericht sichern</translation>
    </message>
    <message>
        <source>Page with charts (*.html);;Table (*.csv);;JSON (*.json)</source>
        <translation>Seite mit Diagrammen (*.html);;Tabelle (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>Saving the report</source>
        <translation>Bericht sichern</translation>
    </message>
    <message>
        <source>The report is saved: %1</source>
        <translation>Der Bericht ist gesichert: %1</translation>
    </message>
</context>
<context>
    <name>limner::WindowAnnotations</name>
    <message>
        <source>Annotations</source>
        <translation>Beschriftung</translation>
    </message>
</context>
<context>
    <name>limner::WindowBackground</name>
    <message>
        <source>Paper colour</source>
        <translation>Papierfarbe</translation>
    </message>
    <message>
        <source>Picture behind the figure</source>
        <translation>Bild hinter der Abbildung</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr);;Everything (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr);;Alles (*)</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Background picture</source>
        <translation>Hintergrundbild</translation>
    </message>
</context>
<context>
    <name>limner::WindowDocuments</name>
    <message>
        <source>%1 copy.limner</source>
        <translation>%1 Kopie.limner</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Kopie speichern</translation>
    </message>
    <message>
        <source>Limner project (*.limner);;Bare figure (*.json)</source>
        <translation>Limner-Projekt (*.limner);;Reine Abbildung (*.json)</translation>
    </message>
    <message>
        <source>“%1” is open in another Limner (%2). You can work on it here; saving asks for another name.</source>
        <translation>„%1“ ist in einem anderen Limner geöffnet (%2). Hier lässt sich daran arbeiten; beim Speichern wird nach einem anderen Namen gefragt.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>Auf gespeicherten Stand zurücksetzen</translation>
    </message>
    <message>
        <source>As it was saved; Undo brings your changes back</source>
        <translation>Wie gespeichert; Rückgängig holt die Änderungen zurück</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved a copy as %1</source>
        <translation>Kopie gespeichert als %1</translation>
    </message>
    <message>
        <source>Take the scan out into a file</source>
        <translation>Die Aufnahme in eine Datei herausnehmen</translation>
    </message>
    <message>
        <source>NRRD volume (*.nrrd)</source>
        <translation>NRRD-Volumen (*.nrrd)</translation>
    </message>
    <message>
        <source>Pack the scan into the project</source>
        <translation>Die Aufnahme ins Projekt packen</translation>
    </message>
    <message>
        <source>The scan goes into the project at the next save</source>
        <translation>Die Aufnahme kommt beim nächsten Speichern ins Projekt</translation>
    </message>
    <message>
        <source>Take the scan out of the project</source>
        <translation>Die Aufnahme aus dem Projekt nehmen</translation>
    </message>
    <message>
        <source>The project refers to the scan&apos;s file from the next save on</source>
        <translation>Vom nächsten Speichern an verweist das Projekt auf die Datei der Aufnahme</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>The scan “%1” is not where it was.</source>
        <translation>Die Aufnahme „%1“ ist nicht mehr, wo sie war.</translation>
    </message>
    <message>
        <source>The second scan “%1” is not where it was.</source>
        <translation>Die zweite Aufnahme „%1“ ist nicht mehr, wo sie war.</translation>
    </message>
    <message>
        <source>The labels “%1” are not where they were.</source>
        <translation>Die Labels „%1“ sind nicht mehr, wo sie waren.</translation>
    </message>
    <message>
        <source>Where is “%1”?</source>
        <translation>Wo ist „%1“?</translation>
    </message>
    <message>
        <source>That file (%1);;Everything (*)</source>
        <translation>Diese Datei (%1);;Alles (*)</translation>
    </message>
    <message>
        <source>Looking for what is missing</source>
        <translation>Fehlendes wird gesucht</translation>
    </message>
    <message>
        <source>Find what was missing</source>
        <translation>Fehlendes finden</translation>
    </message>
    <message>
        <source>The scan was found at %1</source>
        <translation>Die Aufnahme wurde unter %1 gefunden</translation>
    </message>
</context>
<context>
    <name>limner::WindowExport</name>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Pictures are being written</source>
        <translation>Bilder werden geschrieben</translation>
    </message>
    <message>
        <source>Leave now and stop them? What is drawn is kept: the same export goes on there later.</source>
        <translation>Jetzt verlassen und sie anhalten? Was gezeichnet ist, bleibt erhalten: Derselbe Export macht später dort weiter.</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 exportiert</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>%1 picture (*.%2)</source>
        <translation>%1-Bild (*.%2)</translation>
    </message>
    <message>
        <source>Change output size</source>
        <translation>Ausgabegröße ändern</translation>
    </message>
</context>
<context>
    <name>limner::WindowGallery</name>
    <message>
        <source>Added “%1” to your styles</source>
        <translation>„%1“ zu den eigenen Stilen hinzugefügt</translation>
    </message>
    <message>
        <source>Removed “%1” from your styles</source>
        <translation>„%1“ aus den eigenen Stilen entfernt</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Import pictures of shaded balls</source>
        <translation>Bilder schattierter Kugeln importieren</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.psd *.tga *.bmp *.webp);;Everything (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.psd *.tga *.bmp *.webp);;Alles (*)</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>Duplicating %1</source>
        <translation>%1 wird dupliziert</translation>
    </message>
    <message>
        <source>Drawing the scan in a style</source>
        <translation>Die Aufnahme wird in einem Stil gezeichnet</translation>
    </message>
    <message>
        <source>Looking at the picture</source>
        <translation>Das Bild wird angesehen</translation>
    </message>
    <message>
        <source>Selected %1</source>
        <translation>%1 gewählt</translation>
    </message>
</context>
<context>
    <name>limner::WindowHistory</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Name this state</source>
        <translation>Diesen Stand benennen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>State %1</source>
        <translation>Stand %1</translation>
    </message>
    <message>
        <source>Go to “%1”</source>
        <translation>Zu „%1“ gehen</translation>
    </message>
</context>
<context>
    <name>limner::WindowLooks</name>
    <message>
        <source>Keep this look</source>
        <translation>Diesen Look behalten</translation>
    </message>
    <message>
        <source>Name of the look</source>
        <translation>Name des Looks</translation>
    </message>
    <message>
        <source>Import look</source>
        <translation>Look importieren</translation>
    </message>
    <message>
        <source>Looks and projects (*.limner *.json);;Everything (*)</source>
        <translation>Looks und Projekte (*.limner *.json);;Alles (*)</translation>
    </message>
    <message>
        <source>Reading looks</source>
        <translation>Looks werden gelesen</translation>
    </message>
    <message>
        <source>Keeping the look</source>
        <translation>Der Look wird gespeichert</translation>
    </message>
    <message>
        <source>The look “%1” is kept: Looks, Mine</source>
        <translation>Der Look „%1“ ist gespeichert: Looks, Eigene</translation>
    </message>
    <message>
        <source>Importing the look</source>
        <translation>Der Look wird importiert</translation>
    </message>
    <message>
        <source>Removing the look</source>
        <translation>Der Look wird entfernt</translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation>Look %1</translation>
    </message>
</context>
<context>
    <name>limner::WindowRecovery</name>
    <message>
        <source>today, %1</source>
        <translation>heute, %1</translation>
    </message>
    <message>
        <source>yesterday, %1</source>
        <translation>gestern, %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Restoring %1</source>
        <translation>%1 wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Keeping unsaved work</source>
        <translation>Nicht gespeicherte Arbeit wird gesichert</translation>
    </message>
</context>
<context>
    <name>limner::WindowSlices</name>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
</context>
<context>
    <name>limner::WindowStipple</name>
    <message>
        <source>Stipple</source>
        <translation>Punktierung</translation>
    </message>
</context>
<context>
    <name>limner::WindowTransfer</name>
    <message>
        <source>Counting voxels over two axes</source>
        <translation>Voxel werden über zwei Achsen gezählt</translation>
    </message>
    <message>
        <source>Reading the value under the pointer</source>
        <translation>Der Wert unter dem Zeiger wird gelesen</translation>
    </message>
    <message>
        <source>How the voxels lie over these axes is not shown: it depends on the view or on other measures.</source>
        <translation>Wie die Voxel über diesen Achsen liegen, wird nicht gezeigt: Es hängt von der Ansicht oder von anderen Maßen ab.</translation>
    </message>
</context>
<context>
    <name>limner::WindowView</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
</context>
<context>
    <name>limner::WindowWorkspace</name>
    <message>
        <source>The layout “%1” is of another version of the program</source>
        <translation>Die Anordnung „%1“ stammt aus einer anderen Version des Programms</translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>&amp;Keep this layout…</source>
        <translation>Diese Anordnung &amp;behalten …</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Ent&amp;fernen</translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation>Diese Anordnung behalten</translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation>Name der Anordnung</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>The language changes when Limner is started again</source>
        <translation>Die Sprache wechselt beim nächsten Start von Limner</translation>
    </message>
    <message>
        <source>What draws changes when Limner is started again; now: %1</source>
        <translation>Was zeichnet, wechselt beim nächsten Start von Limner; jetzt: %1</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Makes print-ready illustrations of CT and MR scans.</source>
        <translation>Macht druckfertige Illustrationen aus CT- und MR-Aufnahmen.</translation>
    </message>
    <message>
        <source>A scan, a folder of slices, a project or a figure to open.</source>
        <translation>Eine Aufnahme, ein Schichtordner, ein Projekt oder eine Abbildung zum Öffnen.</translation>
    </message>
</context>
</TS>
